// The door of the program, and the only part of it that every processor runs. All else is in libloomlight, which may be
// compiled for processors with AVX2. A package holds that library with AVX2 and without, and the dynamic loader picks;
// where only the one with AVX2 is there, the door says so before the processor meets an instruction that it does not
// know.
#include <cstdio>
#include <string_view>

#include "app/program.h"

#if defined(__x86_64__) && defined(__GLIBC__)
#define _Bool bool  // glibc's header is written in C; NOLINT(bugprone-reserved-identifier)
#include <sys/platform/x86.h>
#undef _Bool
#include <unistd.h>

namespace {

/// Whether processor and system have all of x86-64-v3: the question by which the loader picks.
bool processorIsV3() {
  return x86_cpu_active(x86_cpu_AVX2) && x86_cpu_active(x86_cpu_BMI1) && x86_cpu_active(x86_cpu_BMI2) &&
         x86_cpu_active(x86_cpu_F16C) && x86_cpu_active(x86_cpu_FMA) && x86_cpu_active(x86_cpu_LZCNT) &&
         x86_cpu_active(x86_cpu_MOVBE);
}

/// Ends the program where its library needs what the processor lacks.
void expectProcessor() {
  constexpr std::string_view kMessage =
      "loomlight: this processor lacks AVX2, and this build needs it; one for every processor is made by cmake with "
      "-DLOOMLIGHT_LEVEL=x86-64\n";
  if (!loomlight_needs_v3 || processorIsV3()) return;
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(1);
}

/// Before main is too late: the library's own initialisers, which run earlier, are compiled like the rest of it.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)() = expectProcessor;

}  // namespace
#else
namespace {
bool processorIsV3() {
  return true;
}
}  // namespace
#endif

int main(int argc, char** argv) {
  if (!processorIsV3()) std::fputs("loomlight: this processor lacks AVX2: pictures take longer\n", stderr);
  return loomlight_main(argc, argv);
}
