#pragma once

#include <string_view>

namespace loomlight::fuzz {

// What the fuzzers do with the bytes that they are given: they read them as the program reads a file, or take them for
// what somebody does. Each ends well or throws; what it throws is a finding (finding.h).

void fuzzDrafts(std::string_view bytes);       ///< WIF and Fiberworks' text: read, written, read again
void fuzzFabrics(std::string_view bytes);      ///< JSON: what reads is written and read as the same
void fuzzPalettes(std::string_view bytes);     ///< ASE, ACO, GPL, CxF, tables
void fuzzSwatches(std::string_view bytes);     ///< CGATS, CxF, QTX, tables
void fuzzSpectra(std::string_view bytes);      ///< the spectrum of a lamp, two columns
void fuzzMeshes(std::string_view bytes);       ///< OBJ, PLY, OFF, up to what cloth lies on
void fuzzExr(std::string_view bytes);          ///< pictures, their sizes, their texts
void fuzzPng(std::string_view bytes);          ///< likewise
void fuzzCommandLine(std::string_view bytes);  ///< a word in each line
void fuzzEdits(
    std::string_view bytes);  ///< edits of weave, draft, yarns, fibres, colours, scene: every one leaves a fabric
void fuzzRebuilds(std::string_view bytes);  ///< edits of a cloth: what is kept of its volume is what would be made

}  // namespace loomlight::fuzz
