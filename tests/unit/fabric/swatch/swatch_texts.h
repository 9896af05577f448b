#pragma once

#include <fmt/format.h>

#include <string>

/// One made-up swatch, 400 to 700 nm in steps of 10, in every format: 0.05 at 400 nm, 0.01 more at each step.
namespace loomlight::test {

inline double swatchValue(int i) {
  return 0.05 + 0.01 * i;
}

inline std::string swatchValues(const char* between, double scale, int values = 31) {
  std::string list;
  for (int i = 0; i < values; ++i) list += fmt::format("{}{:.4f}", i ? between : "", scale * swatchValue(i));
  return list;
}

inline std::string wavelengths(const char* between, const char* before, int from_nm = 400, int step_nm = 10) {
  std::string list;
  for (int nm = from_nm; nm <= 700; nm += step_nm)
    list += fmt::format("{}{}{}", nm > from_nm ? between : "", before, nm);
  return list;
}

inline std::string cgatsText() {
  return fmt::format(
      "CGATS.17\n# made up\nORIGINATOR \"a # test\"\nMEASUREMENT_GEOMETRY \"sphere, specular excluded\"\n"
      "NUMBER_OF_FIELDS 33\nBEGIN_DATA_FORMAT\nSAMPLE_ID SAMPLE_NAME {}\nEND_DATA_FORMAT\n"
      "NUMBER_OF_SETS 2\nBEGIN_DATA\n1 \"navy wool\" {}\n2 ecru {}\nEND_DATA\n",
      wavelengths(" ", "SPECTRAL_NM"), swatchValues(" ", 1), swatchValues(" ", 2));
}

inline std::string qtxText() {
  const std::string record =
      "{0}NAME={1},\r\n{0}VIEWING=%R "
      "SCI,\r\n{0}REFLPOINTS=31,\r\n{0}REFLINTERVAL=10,\r\n{0}REFLLOW=400,\r\n{0}R={2},\r\n";
  return "[STANDARD_DATA 0],\r\n" + fmt::format(fmt::runtime(record), "STD_", "navy wool", swatchValues(",", 100)) +
         "[BATCH_DATA 0],\r\nSTD_NAME=navy wool,\r\n" +
         fmt::format(fmt::runtime(record), "BAT_", "lot 7", swatchValues(", ", 90)) + "[OTHER],\r\nSTD_R=1,2,3,\r\n";
}

inline std::string cxfText() {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<cc:CxF xmlns:cc=\"http://colorexchangeformat.com/CxF3-core\">\n"
      "<cc:Resources><cc:ObjectCollection>\n"
      "<cc:Object ObjectType=\"Standard\" Name=\"navy wool\" Id=\"1\"><cc:ColorValues>\n"
      "<cc:ReflectanceSpectrum ColorSpecification=\"CS1\" StartWL=\"400\">{}</cc:ReflectanceSpectrum>\n"
      "<cc:ColorCIELab ColorSpecification=\"CS1\"><cc:L>40</cc:L><cc:A>10</cc:A><cc:B>-20</cc:B></cc:ColorCIELab>\n"
      "</cc:ColorValues></cc:Object>\n</cc:ObjectCollection>\n<cc:ColorSpecificationCollection>\n"
      "<cc:ColorSpecification Id=\"CS1\"><cc:MeasurementSpec>"
      "<cc:GeometryChoice><cc:SphereGeometry><cc:SphereGeometryConfiguration>Specular_Included"
      "</cc:SphereGeometryConfiguration></cc:SphereGeometry></cc:GeometryChoice>"
      "<cc:WavelengthRange StartWL=\"400\" Increment=\"10\"/></cc:MeasurementSpec></cc:ColorSpecification>\n"
      "</cc:ColorSpecificationCollection></cc:Resources></cc:CxF>\n",
      swatchValues(" ", 1));
}

inline std::string csvOfColumns() {
  return "name," + wavelengths(",", "") + "\nnavy wool," + swatchValues(",", 1) + "\n\"ecru\"," + swatchValues(",", 2) +
         "\n";
}

inline std::string csvOfRows() {
  std::string text = "nm;navy wool (SCE);ecru\n";
  for (int i = 0; i <= 30; ++i) {
    std::string line = fmt::format("{};{:.2f};{:.2f}\n", 400 + 10 * i, 100 * swatchValue(i), 200 * swatchValue(i));
    for (char& c : line)
      if (c == '.') c = ',';
    text += line;
  }
  return text;
}

}  // namespace loomlight::test
