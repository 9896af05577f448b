// The one exponential of all light that is absorbed, for every type of number. It is text, to be included inside of a
// namespace: that of plain numbers (polynomials.h), and that of each instruction set which Highway compiles for. There
// it finds broadcast(), most(), towardsZero() and powerOfTwo() of its numbers.

/// e^x for x <= 0, relative error below 5e-6 (2e-7 for x > -1). Never below e^-40, which keeps products of two normal.
template <class T>
[[gnu::always_inline]] inline T exponential(T x) {
  const T t = most(x, broadcast<T>(-40.0f)) * 1.44269504f;
  const T whole = towardsZero(t);
  const T rest = t - whole, square = rest * rest;  // the rest is in (-1, 0]
  const T low = 1.0f + rest * 0.6931470452f + square * (0.2402243312f + rest * 0.05549093212f);
  const T high = 0.009579859973f + rest * 0.001275540135f + square * 0.0001093289239f;
  return (low + square * square * high) * powerOfTwo(whole);
}
