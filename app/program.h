#pragma once

// What the door (app/main.cpp) knows of the library behind it (app/program.cpp).
extern "C" {

/// Whether the library is compiled for processors of the level x86-64-v3: AVX2, FMA and what came with them.
[[gnu::visibility("default")]] extern const bool loomlight_needs_v3;

/// The program: arguments as those of main; returns its exit status.
[[gnu::visibility("default")]] int loomlight_main(int argc, char** argv);
}
