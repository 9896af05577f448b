#pragma once

#include <string>
#include <vector>

#include "app/bench/studies/report_bench.h"
#include "app/cli/fabric_options.h"

namespace loomlight {

/// loomlight bench volume FABRIC: what the volume of a fabric costs at several resolutions, in processor time, so that
/// the figures are per core.
struct BenchCommand {
  std::string input;
  FabricOptions options;
  std::vector<int> resolutions{1, 2, 4, 8};
  /// Per pixel, where the options do not say: a fabric's own number, for a picture without noise, would take an hour.
  static constexpr int kSamples = 2;
  int rounds = 3;   ///< medians are of this many
  int threads = 1;  ///< figures per core are cleanest on one
  bool json = false;
};

/// loomlight bench table1, figures, accuracy or closeup: the report's comparisons, ours beside theirs, and how near
/// ours comes to the fibres, as a folder with a page, pictures and tables.
struct ReportBenchCommand {
  enum class Suite { table1, figures, accuracy, closeup };
  Suite suite = Suite::table1;
  ReportBench bench;
  int threads = 0;  ///< 0: all
};

/// Exit status 0, or 130 when stopped, without a page then. Throws InputError.
int run(const ReportBenchCommand& command);

/// A Markdown table, or JSON, on stdout. Exit status 0, or 130 when stopped. Throws InputError.
int run(const BenchCommand& command);

}  // namespace loomlight
