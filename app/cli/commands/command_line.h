#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/bench/bench_clear.h"
#include "app/bench/bench_command.h"
#include "app/bench/bench_converge.h"
#include "app/bench/bench_edit.h"
#include "app/bench/bench_wardrobe.h"
#include "app/cli/commands/brdf_command.h"
#include "app/cli/commands/bvdf_command.h"
#include "app/cli/commands/colour_command.h"
#include "app/cli/commands/compare_command.h"
#include "app/cli/commands/convert_command.h"
#include "app/cli/commands/handover_command.h"
#include "app/cli/commands/info_command.h"
#include "app/cli/commands/merge_command.h"
#include "app/cli/commands/render_command.h"
#include "app/cli/commands/sheet_command.h"
#include "app/cli/commands/thumbnail_command.h"
#include "app/cli/commands/tile_command.h"
#include "app/cli/commands/trace_command.h"
#include "app/editor/bench_ui.h"
#include "app/editor/editor.h"

namespace loomlight {

/// loomlight [edit] [FABRIC]
struct EditCommand {
  EditorOptions options;
};

/// loomlight bench ui
struct UiBenchCommand {
  UiBenchOptions options;
};

/// --help and --version: text for stdout.
struct TextCommand {
  std::string text;
};

using Command =
    std::variant<EditCommand, RenderCommand, MergeCommand, InfoCommand, ConvertCommand, BenchCommand,
                 ReportBenchCommand, EditBenchCommand, ClearBenchCommand, UiBenchCommand, ConvergeBenchCommand,
                 ClothsBenchCommand, BrdfCommand, CompareCommand, BvdfCommand, TileCommand, HandoverCommand,
                 SheetCommand, ColourCommand, ThumbnailCommand, TraceCommand, TextCommand>;

/// What the words behind the program's name ask for. Throws UsageError.
Command parseCommandLine(const std::vector<std::string>& words);

}  // namespace loomlight
