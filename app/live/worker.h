#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace loomlight {

/// What becomes of requests that nobody has begun, and of work that goes on when its worker dies.
enum class Backlog {
  newest,   ///< only the newest request waits, only the newest result is kept; the end stops the work and waits for it
  every,    ///< all are done, in order, and all results are kept; the end waits for all: nothing is lost
  hanging,  ///< `newest` for work that may never come back, as from a disk that has gone: see Worker
};

/// `background` work lets every other thread of the program go first. The `picture` that the designer waits for does
/// not, nor may anything that starts the pool of parallelFor(): its threads inherit the priority of who starts them.
enum class Priority { background, picture };

/// Does what it is asked for on a thread of its own, which is there for as long as there is something to do.
///
/// Errors: whatever the work throws becomes a result, by `failed`; nothing that is thrown ends the program.
/// Cancel: the work looks at its Job's stop token often. cancel(), forget() and the end request the stop.
/// Hanging work: up to three go on side by side, so that one that hangs does not hold up the next. Only what was asked
/// for last counts. The end waits a moment and leaves behind what hangs still: such work owns all that it uses.
///
/// No call waits, but for the destructor. Any thread may call; results are taken in one.
template <class Request, class Result>
class Worker {
  struct Shared;
  struct Order;

 public:
  class Job;
  /// Makes a result of the request; none where it has been stopped, or all was brought by Job::bring().
  using Work = std::function<std::optional<Result>(const Request&, Job&)>;
  /// What is brought in the place of a result; `problem` is for the user.
  using Failed = std::function<Result(const Request&, const std::string& problem)>;

  /// `wake` may be empty; it is called, from the thread, when there is something to take: never once the end has begun.
  Worker(std::function<void()> wake, Work work, Failed failed, Backlog backlog = Backlog::newest,
         Priority priority = Priority::background)
      : shared_(std::make_shared<Shared>(std::move(wake), std::move(work), std::move(failed), backlog, priority)) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();

  void ask(Request request);
  /// Requests the stop of all work, begun or waiting; work may still bring a result that says how far it came.
  void cancel();
  /// Requests the stop of all work and drops its results, also those that were brought and not taken.
  void forget();
  /// Whether a request has not been begun.
  bool isWaiting() const {
    const std::lock_guard lock(shared_->mutex);
    return !shared_->waiting.empty();
  }
  /// Whether all that was brought has been taken.
  bool isTaken() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->brought.empty();
  }
  /// The oldest result that has not been taken.
  std::optional<Result> take();
  /// A copy of the newest that has not been taken.
  std::optional<Result> newest() const;

 private:
  static void run(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;
  std::thread thread_;  ///< unless work may hang: then they run on their own
};

/// One request's: what its work may ask and tell.
template <class Request, class Result>
class Worker<Request, Result>::Job {
 public:
  const std::stop_token& stop() const { return stop_; }
  bool isStopped() const { return stop_.stop_requested(); }
  /// A result on the way, or one of several.
  void bring(Result result) const { shared_.bring(std::move(result), number_); }
  /// The request that waits, for work that may serve it too as it goes on. None once this job is stopped.
  std::optional<Request> takeNewer() const;
  /// Stops this job, so that the request that waits is begun.
  void giveWay() { source_.request_stop(); }
  /// Stops this job and hands a request that takeNewer() gave back to the next job, unless a newer one waits by now.
  void giveWayTo(Request newer);
  /// Sleeps, but not beyond the stop.
  void rest(std::chrono::milliseconds time) const;

 private:
  friend class Worker;
  Job(Shared& shared, const Order& order)
      : shared_(shared), source_(order.stop), stop_(source_.get_token()), number_(order.number) {}

  Shared& shared_;
  std::stop_source source_;
  std::stop_token stop_;
  uint64_t number_;
};

template <class Request, class Result>
struct Worker<Request, Result>::Order {
  Request request;
  std::stop_source stop;
  uint64_t number = 0;
};

/// Lets every other thread of the program go first, from here on.
void lowerPriorityOfThisThread();
/// What the exception that is being handled says, for the user.
std::string problemCaught();

/// Outlives the worker for as long as a thread that hangs does.
template <class Request, class Result>
struct Worker<Request, Result>::Shared {
  Shared(std::function<void()> toWake, Work toWork, Failed toSay, Backlog kept, Priority rank)
      : wake(std::move(toWake)), work(std::move(toWork)), failed(std::move(toSay)), backlog(kept), priority(rank) {}

  std::optional<Order> next();
  void bring(Result result, uint64_t number);
  void doTurn(const Order& order);
  void stopAll() {  // with the mutex held
    for (Order& order : waiting) order.stop.request_stop();
    for (std::stop_source& stop : underWay) stop.request_stop();
  }

  std::mutex waking;  ///< of the next
  std::function<void()> wake;
  const Work work;
  const Failed failed;
  const Backlog backlog;
  const Priority priority;
  std::mutex mutex;  ///< of all below
  std::condition_variable ended;
  std::deque<Order> waiting;
  std::vector<std::stop_source> underWay;
  std::deque<Result> brought;
  uint64_t wanted = 0;  ///< counts what was forgotten: only results of this number are brought
  int running = 0;      ///< threads
};

template <class Request, class Result>
Worker<Request, Result>::~Worker() {
  constexpr std::chrono::seconds kMoment{1};  // what does not hang has ended before the program's own end begins
  {
    const std::lock_guard lock(shared_->waking);
    shared_->wake = nullptr;
  }
  if (shared_->backlog != Backlog::every) forget();
  if (thread_.joinable()) thread_.join();
  std::unique_lock lock(shared_->mutex);
  shared_->ended.wait_for(lock, kMoment, [this] { return shared_->running == 0; });
}

template <class Request, class Result>
void Worker<Request, Result>::ask(Request request) {
  const bool mayHang = shared_->backlog == Backlog::hanging;
  const int mostAtOnce = mayHang ? 3 : 1;
  if (mayHang) forget();
  std::deque<Order> replaced;  // it may be large: it dies outside the lock
  const std::lock_guard lock(shared_->mutex);
  if (shared_->backlog != Backlog::every) replaced.swap(shared_->waiting);
  shared_->waiting.push_back({std::move(request), {}, shared_->wanted});
  if (shared_->running == mostAtOnce) return;
  if (thread_.joinable()) thread_.join();  // it has nothing left to do but to end
  std::thread thread(run, shared_);
  ++shared_->running;
  if (mayHang)
    thread.detach();
  else
    thread_ = std::move(thread);
}

template <class Request, class Result>
void Worker<Request, Result>::cancel() {
  const std::lock_guard lock(shared_->mutex);
  shared_->stopAll();
}

template <class Request, class Result>
void Worker<Request, Result>::forget() {
  std::deque<Order> orders;  // they die outside the lock
  std::deque<Result> results;
  const std::lock_guard lock(shared_->mutex);
  shared_->stopAll();
  ++shared_->wanted;
  shared_->waiting.swap(orders);
  shared_->brought.swap(results);
}

template <class Request, class Result>
std::optional<Result> Worker<Request, Result>::take() {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->brought.empty()) return std::nullopt;
  std::optional<Result> oldest(std::move(shared_->brought.front()));
  shared_->brought.pop_front();
  return oldest;
}

template <class Request, class Result>
std::optional<Result> Worker<Request, Result>::newest() const {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->brought.empty()) return std::nullopt;
  return shared_->brought.back();
}

template <class Request, class Result>
void Worker<Request, Result>::run(const std::shared_ptr<Shared>& shared) {
  if (shared->priority == Priority::background) lowerPriorityOfThisThread();
  while (const std::optional<Order> order = shared->next()) shared->doTurn(*order);
}

/// Nothing where the thread is to end.
template <class Request, class Result>
auto Worker<Request, Result>::Shared::next() -> std::optional<Order> {
  const std::lock_guard lock(mutex);
  if (waiting.empty()) {
    --running;
    ended.notify_all();
    return std::nullopt;
  }
  std::optional<Order> order(std::move(waiting.front()));
  waiting.pop_front();
  underWay.push_back(order->stop);
  return order;
}

template <class Request, class Result>
void Worker<Request, Result>::Shared::doTurn(const Order& order) {
  try {
    Job job(*this, order);
    std::optional<Result> result;
    try {
      result = work(order.request, job);
    } catch (...) {
      result = failed(order.request, problemCaught());
    }
    if (result) bring(std::move(*result), order.number);
  } catch (...) {
    std::fputs("loomlight: no memory is left, not even to say what went wrong\n", stderr);
  }
  const std::lock_guard lock(mutex);
  std::erase(underWay, order.stop);
}

template <class Request, class Result>
void Worker<Request, Result>::Shared::bring(Result result, uint64_t number) {
  std::deque<Result> replaced;  // they may be large: they die outside the lock
  {
    const std::lock_guard lock(mutex);
    if (number != wanted) return;
    if (backlog != Backlog::every) replaced.swap(brought);
    brought.push_back(std::move(result));
  }
  const std::lock_guard lock(waking);
  if (wake) wake();
}

template <class Request, class Result>
std::optional<Request> Worker<Request, Result>::Job::takeNewer() const {
  const std::lock_guard lock(shared_.mutex);
  if (isStopped() || shared_.waiting.empty()) return std::nullopt;
  std::optional<Request> newer(std::move(shared_.waiting.front().request));
  shared_.waiting.pop_front();
  return newer;
}

template <class Request, class Result>
void Worker<Request, Result>::Job::giveWayTo(Request newer) {
  const std::lock_guard lock(shared_.mutex);
  if (!isStopped() && shared_.waiting.empty()) shared_.waiting.push_front({std::move(newer), {}, number_});
  source_.request_stop();
}

template <class Request, class Result>
void Worker<Request, Result>::Job::rest(std::chrono::milliseconds time) const {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait_for(lock, stop_, time, [] { return false; });
}

}  // namespace loomlight
