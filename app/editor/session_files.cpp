#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor/model/book_colours.h"
#include "app/editor/model/left_work.h"
#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/user_folders.h"
#include "app/editor/session.h"
#include "app/export/file_name.h"
#include "app/export/sheet/cloth_sheet.h"
#include "app/export/sheet/draft_sheet.h"
#include "app/export/weave_bitmap.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/booth_lamps.h"
#include "core/fabric/wif/wif_fabric.h"
#include "render/colour/illuminants.h"
#include "ui/words/common_words.h"
#include "ui/words/file_words.h"
#include "ui/words/message_words.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

fs::path absolute(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);  // fails where the working directory is gone
  return error ? fs::path(file) : whole.lexically_normal();
}

}  // namespace

void Session::leaveFor(Errand next) {
  errand_ = std::move(next);
  if (questions_.isAsking(Question::unsaved)) return;           // the answer is for what was wanted last
  if (files_.service().isReading()) files_.service().cancel();  // a copy that was taken up stays where it is
  if (files_.service().busy()) return;                          // fileDone() comes back here
  if (!document_.document().isDirty()) return goOn();
  questions_.ask(Question::unsaved, words::messages::unsavedTitle,
                 fmt::format(words::messages::unsaved, document_.fabric()->name),
                 {words::common::cancel, words::messages::dontSave, words::common::save}, 2);
}

void Session::goOn() {
  const auto open = [this](FileService::Work work, const std::string& file) {
    files_.service().open(work, file, document_.cloth(), document_.document().state());
  };
  const Errand errand = std::exchange(errand_, {});
  switch (errand.kind) {
    case Errand::Kind::quit:
      window_.isOver = true;
      break;
    case Errand::Kind::beginAnew:
      viewport_.view().fitWanted = true;
      return startOver(Document(newFabric()));
    case Errand::Kind::open:
      return open(FileService::Work::open, errand.file);
    case Errand::Kind::takeUp:
      return open(FileService::Work::takeUp, errand.file);
    case Errand::Kind::none:
      break;
  }
}

void Session::answered(const QuestionController::Answer& answer) {
  switch (answer.question) {
    case Question::unsaved:
      if (answer.answer == 0) errand_ = {};
      if (answer.answer == 1) goOn();
      if (answer.answer == 2) run(Command::save);
      break;
    case Question::forgetRecent:
      if (answer.answer == 1) forget(settings_.recent, answer.file);
      break;
    case Question::recover:
      if (answer.answer == 1) document_.throwAway(answer.file);
      if (answer.answer == 2) leaveFor({Errand::Kind::takeUp, answer.file});
      break;
    case Question::said:
    case Question::none:
      break;
  }
}

void Session::lookNextIn(const std::string& fileThere) {
  settings_.folder = absolute(fileThere).parent_path().string();
}

void Session::remember(const std::string& file) {
  lookNextIn(file);
  loomlight::remember(settings_.recent, absolute(file).string());
}

void Session::openRecent(const std::string& file) {
  lookFor(settings_.recent);
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) return openFile(file);
  questions_.ask(Question::forgetRecent, words::messages::missingTitle, fmt::format(words::messages::missing, file),
                 {words::messages::keepInList, words::messages::forgetIt}, 0, file);
}

/// What has waited until no dialog is open: work that another editor left, and files that were dropped.
void Session::openPending() {
  if (recoveryIsDue_ && !dialogIsOpen()) {
    recoveryIsDue_ = false;
    if (const auto left = Autosave::leftBehind(stateFolder()))
      questions_.ask(Question::recover, words::messages::leftTitle,
                     fmt::format(words::messages::takeItUp, aboutLeftWork(*left)),
                     {words::messages::later, words::messages::throwAway, words::messages::takeUp}, 2, left->string());
  }
  files_.placeDropped(yarnUnderPointer());
  while (!dialogIsOpen()) {
    const auto dropped = files_.takeDropped();
    if (!dropped) return;
    openFile(dropped->file, dropped->yarn);
  }
}

/// The picture may be of an older fabric that had more yarns.
std::optional<int> Session::yarnUnderPointer() {
  const auto& pointer = viewport_.view().pointer;
  const auto hit = pointer ? viewport_.service().hitAt(*pointer) : std::nullopt;
  if (!hit) return std::nullopt;
  return std::min(hit->yarn, static_cast<int>(document_.fabric()->yarns.size()) - 1);
}

void Session::openFile(const std::string& file, const std::optional<int>& yarn) {
  const std::string extension = lowerExtension(file);
  if (extension == ".obj" || extension == ".ply" || extension == ".off") {
    document_.change([&](Fabric& fabric) {
      fabric.drape.kind = DrapeKind::mesh;
      fabric.drape.file = file;
    });
    viewport_.view().fitWanted = true;
  } else if (extension == ".exr") {
    document_.change([&](Fabric& fabric) {
      fabric.light.kind = LightKind::environment;
      fabric.light.file = file;
    });
  } else if (isSwatchFile(file) || isPaletteFile(file)) {
    openColours(file, yarn);
  } else if (extension == ".icc" || extension == ".icm") {
    profiles_.open(file);
    lookNextIn(file);
  } else if (extension == ".png") {
    draft_.openPicture(file);
    lookNextIn(file);
  } else if (!isFabricFile(file) && isIlluminantFile(file)) {  // a draft may be a .txt as well
    openLamp(file);
  } else if (isFabricFile(file) || isWeavingFile(file)) {
    leaveFor({Errand::Kind::open, file});
  } else if (const auto program = programOfForeignDraft(file)) {
    sayUnopened(fmt::format(words::messages::foreignDraft, file, *program));
  } else {
    sayUnopened(fmt::format(words::messages::unknownKind, file));
  }
}

/// One measured swatch dyes the yarn that it was dropped on, or what is looked at, so that the cloth reflects as was
/// measured; several, and the colours of a palette, are there to choose from.
void Session::openColours(const std::string& file, const std::optional<int>& yarn) {
  settings_.dock.panelsShown = true;  // where it is told what came of it
  try {
    const ColourFile colours = readColourFile(file);
    if (colours.swatch)
      inspector_.dyeLike(*document_.fabric(), *colours.swatch, yarn);
    else
      inspector_.open(colours.palette, absolute(file).string());
    if (!colours.remarks.empty())
      questions_.say(words::messages::coloursRead, fmt::format("{}", fmt::join(colours.remarks, "\n\n")));
  } catch (const InputError& error) {
    sayUnopened(error.what());
  }
}

/// The cloth is seen by the spectrum of this lamp.
void Session::openLamp(const std::string& file) {
  const std::string whole = absolute(file).string();
  try {
    illuminantCalled(whole);
  } catch (const InputError& error) {
    return sayUnopened(error.what());
  }
  lookNextIn(file);
  document_.change([&](Fabric& fabric) {
    fabric.light = underLamp(fabric.light, StandardIlluminant::file);
    fabric.light.illuminantFile = whole;
  });
}

void Session::sayLooksOtherwise(const std::string& file, const std::vector<WifWarning>& remarks) {
  if (remarks.empty()) return;
  std::string text = file;
  for (const WifWarning& remark : remarks) text += "\n\n" + remark.sentence;
  questions_.say(words::messages::looksOtherwise, text);
}

void Session::opened(FileService::Result result) {
  if (!isWeavingFile(result.file)) {
    startOver(Document(std::move(*result.fabric), result.file));
    sayLooksOtherwise(result.file, result.warnings);
  } else {
    // As the file says, where it does; the dialog that says so has the designer's own on offer.
    const auto mine = std::make_shared<const Fabric>(std::move(*result.fabric));
    std::vector<WifWarning> said;  // by the dialog
    startOver(Document(withWifSizes(*mine, said)));
    draft_.askForSizes(mine, std::move(result.warnings), result.named);
  }
  remember(result.file);
}

void Session::takeUp(Fabric fabric, const std::string& left) {
  startOver(Document::unsaved(std::move(fabric)));  // not into a file that was just opened
  document_.takeOver(left);
}

void Session::fileDone(FileService::Result result) {
  using Work = FileService::Work;
  const bool written = !FileService::reads(result.work);
  if (result.work == Work::renderTo) viewport_.service().pause(ViewService::Rival::sheet, false);
  if (!result.problem.empty() || result.cancelled) errand_ = {};
  if (result.cancelled) return;
  if (!result.problem.empty() && result.work == Work::usePreset)
    return questions_.say(words::messages::presetUnusedTitle, result.problem);
  if (!result.problem.empty() && !written) return sayUnopened(result.problem);
  if (!result.problem.empty())
    return questions_.say(words::messages::unwrittenTitle, fmt::format(words::messages::unwritten, result.problem));
  // Workers go on while a file is read: what they have edited since is asked about too.
  const bool editedSince = !written && result.state != document_.document().state() && document_.document().isDirty();
  switch (result.work) {
    case Work::open:
      if (!editedSince) return opened(std::move(result));
      return leaveFor({Errand::Kind::open, result.file});
    case Work::takeUp:
      if (editedSince) return leaveFor({Errand::Kind::takeUp, result.file});
      return takeUp(std::move(*result.fabric), result.file);
    case Work::usePreset:
      return dress(*result.fabric);
    case Work::save:
      document_.savedAs(result.file, result.state);
      remember(result.file);
      break;
    case Work::exportTo:
    case Work::renderTo:
      lookNextIn(result.file);
      std::string text = fmt::format(words::messages::written, result.file);
      for (const std::string& remark : result.remarks) text += "\n\n" + remark;
      questions_.say(words::messages::exported, text);
  }
  if (errand_.kind != Errand::Kind::none) leaveFor(errand_);
}

fs::path Session::folderToLookIn() const {
  return settings_.folder.empty() ? homeFolder() : fs::path(settings_.folder);
}

fs::path Session::fileCalledAsCloth(const std::string& ending) const {
  return folderToLookIn() / (fileNameOf(document_.fabric()->name) + ending);
}

/// Where the browser begins.
fs::path Session::startOf(FileTask task) const {
  const std::string& file = document_.document().file();
  switch (task) {
    case FileTask::saveAs:
      return file.empty() ? fileCalledAsCloth(".loomlight") : fs::path(file);
    case FileTask::snapshot:
      return snapshots_.file();
    case FileTask::exportTile:
      return tile_.file();
    case FileTask::handover:
      return handover_.folder();
    case FileTask::exportWif:
      return fileCalledAsCloth(".wif");
    case FileTask::exportDraft:
      return fileCalledAsCloth(".pdf");
    case FileTask::exportBitmap:
      return fileCalledAsCloth(".png");
    case FileTask::sheet:
      return fileCalledAsCloth(words::files::sheetEnding);
    case FileTask::colourwaySheet:
      return fileCalledAsCloth(words::files::colourwaysEnding);
    default:
      return folderToLookIn();
  }
}

void Session::fileChosen(const FileController::Chosen& chosen) {
  switch (chosen.task) {
    case FileTask::open:
    case FileTask::mesh:
    case FileTask::environment:
    case FileTask::picture:
    case FileTask::profile:
      return openFile(chosen.file);
    case FileTask::saveAs:
      return files_.service().save(chosen.file, document_.cloth(), document_.document().state());
    case FileTask::snapshot:
      return snapshots_.setFile(chosen.file);
    case FileTask::exportTile:
      return tile_.setFile(chosen.file);
    case FileTask::handover:
      return handover_.setFolder(chosen.file);
    case FileTask::exportWif:
    case FileTask::exportBitmap:
      return exportTo(chosen.task, chosen.file);
    case FileTask::exportDraft:
      return printDraft(chosen.file);
    case FileTask::sheet:
    case FileTask::colourwaySheet:
      return writeSheet(chosen.task, chosen.file);
    case FileTask::none:
      break;
  }
}

void Session::writeSheet(FileTask what, const std::string& file) {
  ClothSheetOptions options;
  options.width_cm = inspector_.view().units.piece.width_cm;
  options.counts = inspector_.view().units.count;
  options.corner = {settings_.draft.startsRight(), settings_.draft.startsAtTop()};
  viewport_.service().pause(ViewService::Rival::sheet, true);
  files_.service().renderTo(file, [what, file, options, fabric = document_.cloth()](const Task& task) {
    const auto write = what == FileTask::sheet ? writeClothSheet : writeColourwaySheet;
    return write(file, *fabric, options, task);
  });
}

void Session::exportTo(FileTask task, const std::string& file) {
  files_.service().exportTo(file, [task, file, fabric = document_.cloth()]() -> std::vector<std::string> {
    if (task == FileTask::exportWif) return writeWifFabric(*fabric, file);
    writeWeaveBitmap(file, *fabric);
    return {};
  });
}

void Session::printDraft(const std::string& file) {
  const DraftCorner corner{settings_.draft.startsRight(), settings_.draft.startsAtTop()};
  files_.service().renderTo(file, [file, corner, fabric = document_.cloth()](const Task& task) {
    Task colours = task;
    colours.progress = nullptr;  // they take a moment
    return writeDraftSheet(file, *fabric, corner, colours);
  });
}

}  // namespace loomlight
