#include "app/editor/controllers/inset_model.h"

#include <gmock/gmock.h>

namespace loomlight {
namespace {

using testing::HasSubstr;
using Phase = InsetStatus::Phase;

Drape flat(double width_mm, double height_mm) {
  Drape drape;
  drape.kind = DrapeKind::flat;
  drape.width_mm = width_mm;
  drape.height_mm = height_mm;
  return drape;
}

InsetFrame frameWith(int samples) {
  auto frame = std::make_shared<Frame>();
  frame->samples = samples;
  return {frame, nullptr};
}

TEST(InsetModel, SaysWhatTheFibresTakeWhileTheyAreLaid) {
  InsetStatus status;
  status.phase = Phase::laying;
  status.progress = 0.431;
  status.segments = 12.34e6;
  status.bytes = 1.18e9;
  const InsetModel model = insetModel(status, nullptr, false, 8e9, flat(20, 20));
  EXPECT_EQ(model.caption, "laying 12.3 million fibre segments, 1.2 GB: 43 %");
  EXPECT_TRUE(model.laying);
  EXPECT_EQ(model.trouble, "");
}

TEST(InsetModel, RefusesInPlainWordsAndOffersWhatHelps) {
  InsetStatus status;
  status.phase = Phase::tooLarge;
  status.segments = 1.2e9;
  status.bytes = 115e9;
  const InsetModel model = insetModel(status, nullptr, false, 8.8e9, flat(160, 80));
  EXPECT_THAT(model.trouble, HasSubstr("1.2 billion segments, would take 115.0 GB"));
  EXPECT_THAT(model.trouble, HasSubstr("The limit is 8.8 GB"));
  EXPECT_EQ(model.remedy, "Make it 43 \xC3\x97 21 mm");
  EXPECT_TRUE(model.limitMatters);
  Drape mesh = flat(160, 80);
  mesh.kind = DrapeKind::mesh;
  EXPECT_EQ(insetModel(status, nullptr, false, 8.8e9, mesh).remedy, "");
  EXPECT_THAT(insetModel(status, nullptr, false, 8.8e9, mesh).trouble, HasSubstr("laid flat, one repeat"));
}

TEST(InsetModel, CaptionsWhatIsSeen) {
  InsetStatus status;
  status.phase = Phase::tracing;
  InsetFrame frame = frameWith(12);
  EXPECT_EQ(insetModel(status, &frame, false, 8e9, flat(20, 20)).caption, "fibres, 12 samples");
  EXPECT_EQ(insetModel(status, &frame, true, 8e9, flat(20, 20)).caption, "difference, waiting for samples");
  status.phase = Phase::converged;
  EXPECT_EQ(insetModel(status, &frame, true, 8e9, flat(20, 20)).caption, "difference, waiting for samples")
      << "of the picture, which the lens is ahead of";
  const InsetFrame ofOne = frameWith(1);
  EXPECT_EQ(insetModel(status, &ofOne, true, 8e9, flat(20, 20)).caption, "difference: not known of one sample a pixel");
  status.phase = Phase::tracing;
  EXPECT_EQ(insetModel(status, &ofOne, true, 8e9, flat(20, 20)).caption, "difference, waiting for samples");
  auto difference = std::make_shared<Difference>();
  difference->mean_percent = 1.26;
  difference->error_percent = 0.24;
  frame.difference = difference;
  const InsetModel model = insetModel(status, &frame, true, 8e9, flat(20, 20));
  EXPECT_EQ(model.caption,
            "difference \xC3\x97"
            "4, mean +1.3 \xC2\xB1 0.2 %");
  EXPECT_EQ(model.scaleEnd, "25 %");
  EXPECT_GT(model.scale.size(), 8u);
  status.isWholePiece = false;
  EXPECT_EQ(insetModel(status, &frame, false, 8e9, flat(20, 20)).caption, "fibres of one repeat, 12 samples");
  status.isWholePiece = true;
  frame = frameWith(0);
  EXPECT_EQ(insetModel(status, &frame, false, 8e9, flat(20, 20)).caption, "fibres, preview");
}

TEST(FittingPiece, KeepsTheProportionsAndFits) {
  const auto piece = fittingPiece(flat(300, 200), 100e9, 4e9);
  ASSERT_TRUE(piece);
  EXPECT_LE(piece->width_mm * piece->height_mm / (300 * 200) * 100e9, 4e9);
  EXPECT_GT(piece->width_mm * piece->height_mm / (300 * 200) * 100e9, 3.4e9);
  EXPECT_NEAR(piece->width_mm / piece->height_mm, 1.5, 0.1);
  EXPECT_FALSE(fittingPiece(flat(300, 200), 3e9, 4e9)) << "it fits as it is";
  EXPECT_FALSE(fittingPiece(flat(10, 10), 100e9, 0.1e9)) << "there would be nothing left to look at";
}

}  // namespace
}  // namespace loomlight
