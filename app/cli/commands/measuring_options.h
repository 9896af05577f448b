#pragma once

#include "app/cli/commands/command_line.h"

namespace CLI {
class App;
}

namespace loomlight {

// What the commands that measure take, described to the library that reads the command line.

void addVolumeBench(CLI::App& app, BenchCommand& command);
void addReportBench(CLI::App& app, ReportBenchCommand& command);
void addUiBench(CLI::App& app, UiBenchOptions& options);
void addEditBench(CLI::App& app, EditBenchCommand& command);
void addConvergeBench(CLI::App& app, ConvergeBenchCommand& command);
void addClearBench(CLI::App& app, ClearBenchCommand& command);
void addClothsBench(CLI::App& app, ClothsBenchCommand& command);
void addBrdf(CLI::App& app, BrdfCommand& command);
void addBvdf(CLI::App& app, BvdfCommand& command);
void addColour(CLI::App& app, ColourCommand& command);
void addCompare(CLI::App& app, CompareCommand& command);

}  // namespace loomlight
