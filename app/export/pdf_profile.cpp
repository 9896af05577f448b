#include "app/export/pdf_profile.h"

#define POINTERHOLDER_TRANSITION 4  // qpdf 11: its old pointers are not used
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <memory>

#include "render/colour/icc_profile.h"

// How it works. cairo writes colours as numbers of an unnamed device. PDF lets the resources of a page, and of each
// form on it, say what that device is (DefaultRGB, ISO 32000-1, 8.6.5.6), so no drawing has to be written anew.
namespace loomlight {
namespace {

QPDFObjectHandle profileIn(QPDF& pdf) {
  QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf, sRgbProfile());
  stream.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(3));
  stream.getDict().replaceKey("/Alternate", QPDFObjectHandle::newName("/DeviceRGB"));
  return pdf.makeIndirectObject(stream);
}

void addDefault(QPDFObjectHandle resources, const QPDFObjectHandle& space) {
  if (!resources.getKey("/ColorSpace").isDictionary())
    resources.replaceKey("/ColorSpace", QPDFObjectHandle::newDictionary());
  resources.getKey("/ColorSpace").replaceKey("/DefaultRGB", space);
}

QPDFObjectHandle outputIntent(const QPDFObjectHandle& profile) {
  constexpr const char* kName = "sRGB IEC61966-2.1";
  QPDFObjectHandle intent = QPDFObjectHandle::newDictionary();
  intent.replaceKey("/Type", QPDFObjectHandle::newName("/OutputIntent"));
  intent.replaceKey("/S", QPDFObjectHandle::newName("/GTS_PDFA1"));
  intent.replaceKey("/OutputConditionIdentifier", QPDFObjectHandle::newString(kName));
  intent.replaceKey("/RegistryName", QPDFObjectHandle::newString("http://www.color.org"));
  intent.replaceKey("/Info", QPDFObjectHandle::newString(kName));
  intent.replaceKey("/DestOutputProfile", profile);
  return intent;
}

}  // namespace

std::string withSrgbProfile(const std::string& bytes) {
  QPDF pdf;
  pdf.processMemoryFile("sheet", bytes.data(), bytes.size());
  const QPDFObjectHandle profile = profileIn(pdf);
  QPDFObjectHandle space = QPDFObjectHandle::newArray();
  space.appendItem(QPDFObjectHandle::newName("/ICCBased"));
  space.appendItem(profile);
  space = pdf.makeIndirectObject(space);
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(pdf).getAllPages()) {
    addDefault(page.getAttribute("/Resources", true), space);
    page.forEachFormXObject(true, [&](QPDFObjectHandle& form, QPDFObjectHandle&, const std::string&) {
      QPDFObjectHandle dictionary = form.getDict();
      if (!dictionary.getKey("/Resources").isDictionary())
        dictionary.replaceKey("/Resources", QPDFObjectHandle::newDictionary());
      addDefault(dictionary.getKey("/Resources"), space);
    });
  }
  QPDFObjectHandle intents = QPDFObjectHandle::newArray();
  intents.appendItem(outputIntent(profile));
  pdf.getRoot().replaceKey("/OutputIntents", intents);
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.write();
  const std::shared_ptr<Buffer> written = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(written->getBuffer()), written->getSize()};
}

}  // namespace loomlight
