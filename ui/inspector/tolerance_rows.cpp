#include "ui/inspector/tolerance_rows.h"

#include <fmt/core.h>

#include "ui/widgets/choices.h"
#include "ui/words/booth_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

using Judged = std::optional<ClothColourModel::Judged>;

std::string helpOf(const Word& word, const Judged& judged, double error) {
  return judged ? word.help + fmt::format(words::booth::figures, judged->cmc, judged->ciede2000, error) : word.help;
}

void verdictRow(Ui& ui, const char* id, const std::string& label, const Word& word, const Judged& judged, double error,
                double tolerance_cmc) {
  const std::string help = helpOf(word, judged, error);
  readout(ui, {id, label.c_str(), help.c_str()},
          judged ? verdictText(judged->cmc, tolerance_cmc) : words::panels::none);
}

}  // namespace

void toleranceField(Ui& ui, const char* id, double& tolerance_cmc) {
  NumberStyle style;
  style.unit = words::booth::toleranceUnit;
  style.min = kTolerance_cmc[0];
  style.max = kTolerance_cmc[1];
  style.logarithmic = true;
  numberField(ui, {id, words::booth::tolerance}, style, tolerance_cmc);
}

/// Words say whether it passes: a colour alone would be lost on who sees colours otherwise, and on paper.
std::string verdictText(double cmc, double tolerance_cmc) {
  return fmt::format(words::booth::verdict, cmc, cmc <= tolerance_cmc ? words::booth::passes : words::booth::fails);
}

void toleranceRows(Ui& ui, const ClothColourModel& model, double& tolerance_cmc) {
  namespace said = words::booth;
  toleranceField(ui, "fibre.tolerance", tolerance_cmc);
  const StandardIlluminant own = model.present ? model.present->lamp : StandardIlluminant::d65;
  verdictRow(ui, "fibre.verdict", fmt::format(said::present.label, lampWord(own)), said::present, model.present,
             model.error, tolerance_cmc);
  const std::string worst =
      model.worst ? fmt::format(said::worst.label, lampWord(model.worst->lamp)) : said::worstOfNone;
  verdictRow(ui, "fibre.verdict_worst", worst, said::worst, model.worst, model.error, tolerance_cmc);
  ui.probe.fact("fibre.verdict_worst_lamp", model.worst ? lampWord(model.worst->lamp) : "");
  readout(ui, {"fibre.metamerism", said::metamerism.label, said::metamerism.help},
          model.worst ? fmt::format("{:.2f}", model.worst->metamerism) : words::panels::none);
}

}  // namespace loomlight
