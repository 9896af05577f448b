#include "app/cli/version_text.h"

#include <OpenMesh/Core/System/config.h>
#include <fmt/format.h>

#include "commit.h"
#include "render/scene/processor_kind.h"
#include "render/walk/walk_target.h"

namespace loomlight {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "Clang " __clang_version__;
#elif defined(__GNUC__)
constexpr const char* kCompiler = "GCC " __VERSION__;
#else
constexpr const char* kCompiler = "unknown";
#endif

#if defined(__AVX2__)
constexpr const char* kInstructionSet = "x86-64-v3 (AVX2)";
#elif defined(__x86_64__)
constexpr const char* kInstructionSet = "x86-64";
#elif defined(__aarch64__)
constexpr const char* kInstructionSet = "AArch64";
#else
constexpr const char* kInstructionSet = "unknown";
#endif

}  // namespace

std::string buildName() {
  return "loomlight " LOOMLIGHT_VERSION ", commit " LOOMLIGHT_COMMIT;
}

std::string versionText() {
  // OpenMesh has no version that CMake could find.
  return fmt::format(
      "loomlight {}\ncommit: {}\ncompiler: {}\ninstruction set: {}\nvectors: {}\nkind of processor: {}\nlibraries: {}, "
      "OpenMesh {}.{}\n",
      LOOMLIGHT_VERSION, LOOMLIGHT_COMMIT, kCompiler, kInstructionSet, walkTarget(), processorKind(),
      LOOMLIGHT_LIBRARIES, OM_GET_VER, OM_GET_MAJ);
}

}  // namespace loomlight
