#include "app/program.h"

#include <fmt/format.h>
#include <signal.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "app/cli/commands/command_line.h"
#include "app/cli/usage_error.h"
#include "app/editor/editor.h"
#include "core/base/error.h"

namespace loomlight {
namespace {

constexpr int kBadInput = 1, kBadUsage = 2;

/// What was printed counts once it has arrived: that a disk is full shows when the last of it is flushed.
void expectPrinted() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw InputError(
        fmt::format("the output cannot be written{}{}", errno ? ": " : "", errno ? std::strerror(errno) : ""));
}

int run(const TextCommand& command) {
  fmt::print("{}", command.text);
  return 0;
}

int run([[maybe_unused]] const EditCommand& command) {
#ifdef LOOMLIGHT_EDITOR
  return runEditor(command.options);
#else
  throw InputError("edit: this program was built without the editor (LOOMLIGHT_EDITOR=OFF)");
#endif
}

int run([[maybe_unused]] const UiBenchCommand& command) {
#ifdef LOOMLIGHT_EDITOR
  return runUiBench(command.options);
#else
  throw InputError("bench ui: this program was built without the editor (LOOMLIGHT_EDITOR=OFF)");
#endif
}

/// Says why the program ends. fmt::print would throw where that cannot be written, as in a log on a full disk.
void say(const std::string& why) {
  std::fputs(("loomlight: " + why + "\n").c_str(), stderr);
}

}  // namespace
}  // namespace loomlight

const bool loomlight_needs_v3 =
#ifdef __AVX2__
    true;
#else
    false;
#endif

int loomlight_main(int argc, char** argv) {
  using namespace loomlight;
  // A file beyond the size that is allowed fails to be written, which says so and leaves the old one, instead of ending
  // the program.
  signal(SIGXFSZ, SIG_IGN);
  try {
    const Command command = parseCommandLine({argv + (argc > 0), argv + argc});
    const int status = std::visit([](const auto& chosen) { return run(chosen); }, command);
    expectPrinted();
    return status;
  } catch (const UsageError& error) {
    say(std::string(error.what()) + "\nloomlight --help says more");
    return kBadUsage;
  } catch (const InputError& error) {
    say(error.what());
  } catch (const std::bad_alloc&) {
    say("there is not enough memory for this");
  } catch (const std::exception& error) {
    say(error.what());
  }
  return kBadInput;
}
