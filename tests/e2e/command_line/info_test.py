"""`info` says what follows from a fabric."""

import json
import math
import re

from harness import ROOT, SAMPLES, CommandLineTest, main

KEYS = """ends picks shafts treadles warp_up_cells max_warp_float max_weft_float cover_factor areal_mass_g_m2
thickness_mm crimp_warp crimp_weft warnings bricks voxels components volume_bytes segments_represented""".split()


class Info(CommandLineTest):
    def test_the_numbers_of_a_twill(self):
        info = json.loads(self.run_program("info", self.fabric(), "--json"))
        self.assertEqual([key for key in KEYS if key not in info], [])
        self.assertEqual((info["ends"], info["picks"]), (4, 4))
        self.assertEqual((info["shafts"], info["treadles"]), (4, 4))
        self.assertEqual(info["warp_up_cells"], 8)
        self.assertEqual((info["max_warp_float"], info["max_weft_float"]), (2, 2))
        self.assertIsInstance(info["warnings"], list)
        # 40 fibres of cotton of 9 um in every yarn; g/km = g/cm3 * mm2 * 1000.
        tex = 40 * 1.52 * 3.14159265 * 0.009**2 * 1000
        uncrimped = 0.1 * (20 + 18) * tex
        self.assertGreater(info["areal_mass_g_m2"], uncrimped)
        self.assertLess(info["areal_mass_g_m2"], 1.3 * uncrimped)

    def test_long_floats_are_listed_with_their_places(self):
        # The last pick passes over three ends, from end 2 on; ends are 2 mm apart.
        fabric = self.fabric(weave=["#...", "#.#.", ".#.#", "#.#."], ends_per_cm=5, picks_per_cm=20)
        listed = json.loads(self.run_program("info", fabric, "--json", "--float-limit", 5))["long_floats"]
        self.assertEqual((listed["limit_mm"], listed["count"]), (5, 1))
        run = listed["longest"][0]
        self.assertEqual((run["system"], run["face"], run["thread"], run["first"], run["cells"]),
                         ("weft", True, 4, 2, 3))
        self.assertIn("pick 4, from end 2 over 3, on the face", self.run_program("info", fabric, "--float-limit", 5))
        self.assertEqual(json.loads(self.run_program("info", fabric, "--json", "--float-limit", 50))["long_floats"],
                         {"limit_mm": 50, "count": 0, "longest": []})

    def test_the_pattern_repeats_with_weave_and_colours(self):
        fabric = self.fabric(warp_sequence=[0, 0, 1], ends_per_cm=20, picks_per_cm=18)
        info = json.loads(self.run_program("info", fabric, "--json"))
        self.assertEqual((info["pattern_ends"], info["pattern_picks"]), (12, 4))
        self.assertAlmostEqual(info["pattern_width_mm"], 6)
        self.assertIn("mm, 12 x 4 threads", self.run_program("info", fabric))

    def test_a_thread_that_nothing_binds_floats_without_end(self):
        fabric = self.fabric(weave=["#..#", "##..", "###.", "#.##"])
        self.assertEqual(json.loads(self.run_program("info", fabric, "--json"))["unbound_ends"], 1)
        self.assertRegex(self.run_program("info", fabric), r"longest warp float +endless +ends bound by none: 1")

    def test_every_sample_has_plausible_numbers(self):
        for sample in sorted(SAMPLES.glob("*.json")):
            with self.subTest(sample=sample.name):
                info = json.loads(self.run_program("info", sample, "--json", "--resolution", 1))
                self.assertTrue(10 < info["areal_mass_g_m2"] < 1500, info["areal_mass_g_m2"])  # from chiffon to carpet
                self.assertTrue(0.02 < info["thickness_mm"] < 5, info["thickness_mm"])
                self.assertTrue(0 <= info["crimp_warp"] < 0.5 and 0 <= info["crimp_weft"] < 0.5)
                self.assertTrue(0 < info["warp_up_cells"] < info["ends"] * info["picks"])
                self.assertGreater(info["segments_represented"], 1000)

    def test_the_figures_of_the_desk_are_there(self):
        yarns = [{"name": name, "fibre": 0, "count_tex": tex} for name, tex in (("warp", 16), ("weft", 20))]
        fabric = self.fabric(yarns=yarns)
        info = json.loads(self.run_program("info", fabric, "--json", "--resolution", 1, "--piece", "2x50"))
        self.assertEqual((info["warp_count_tex"], info["weft_count_tex"]), (16, 20))
        self.assertEqual((info["repeat_width_mm"], info["warp_on_face"]), (2, 0.5))
        self.assertAlmostEqual(info["repeat_height_mm"], 40 / 18)
        self.assertEqual(info["interlacings"], 16)  # each of 4 ends and 4 picks changes sides twice
        self.assertAlmostEqual(info["cover_fraction"], info["cover_factor"] / 28)
        self.assertTrue(info["cover_fraction"] < info["area_covered"] < 1, "yarns lie wider than round")
        self.assertRegex(self.run_program("info", fabric, "--resolution", 1),
                         rf"area covered +{100 * info['area_covered']:.0f} %.* by round ones "
                         rf"{100 * info['cover_fraction']:.0f} %, the cover factor over 28")
        need = info["yarn_need"]
        self.assertEqual((need["length_m"], need["width_cm"]), (2, 50))
        warp, weft = need["yarns"]
        self.assertEqual((warp["name"], warp["weft_m"], weft["warp_m"]), ("warp", 0, 0))
        self.assertAlmostEqual(warp["warp_m"], 2 * 50 * 20 * (1 + info["crimp_warp"]))
        self.assertAlmostEqual(weft["weft_m"], 0.5 * 200 * 18 * (1 + info["crimp_weft"]))
        # Of a square metre.
        mass_g = 1000 * (warp["mass_kg"] + weft["mass_kg"])
        self.assertAlmostEqual(mass_g, info["areal_mass_g_m2"], delta=1e-3 * mass_g)
        for wrong in ("10", "0x150", "10x150x2", "10xwide"):
            self.assertIn("--piece", self.run_program("info", fabric, "--piece", wrong, status=2))

    def test_the_states_of_the_cloth_say_where_they_are_from(self):
        plain = json.loads(self.run_program("info", self.fabric(), "--json", "--resolution", 1))
        self.assertIsNone(plain["reed_per_10cm"])
        setts = plain["setts"]
        self.assertEqual(list(setts), ["reed", "loom", "finished", "washed"])
        self.assertAlmostEqual(setts["reed"]["ends"]["per_cm"], 20 / (1 + plain["crimp_weft"]))
        self.assertAlmostEqual(setts["reed"]["picks"]["per_cm"], 18 / (1 + plain["crimp_warp"]))
        self.assertEqual(setts["reed"]["ends"]["from"], "from crimp")
        self.assertEqual(setts["loom"]["ends"], {"per_cm": None, "from": "not known"})
        self.assertEqual((setts["finished"]["ends"]["per_cm"], setts["finished"]["picks"]["per_cm"]), (20, 18))
        mill = {"reed_per_10cm": 120, "ends_per_dent": [3, 0], "loom_ends_per_cm": 19, "selvedge_ends": 24,
                "selvedge_ends_per_dent": 4, "selvedge_weave": "plain", "washed_picks_per_cm": 19}
        fabric = self.fabric(mill=mill)
        told = json.loads(self.run_program("info", fabric, "--json", "--resolution", 1, "--piece", "10x90"))
        self.assertEqual(told["setts"]["reed"]["ends"], {"per_cm": 18, "from": "reed and denting"})
        self.assertEqual(told["setts"]["loom"]["ends"], {"per_cm": 19, "from": "counted by the mill"})
        self.assertEqual(told["setts"]["washed"]["picks"]["per_cm"], 19)
        # 90 cm at 20 ends to the cm by 18 in the reed, and 6 dents on each side of 12 to the cm.
        self.assertAlmostEqual(told["reed_width_cm"], 100 + 1)
        for key in ("areal_mass_g_m2", "crimp_warp", "voxels"):
            self.assertEqual(told[key], plain[key], "no picture depends on what the mill writes")
        table = self.run_program("info", fabric, "--resolution", 1)
        for line in ("dents/10 cm, ends per dent 3 0", "24 each side, 4 per dent, plain", "ends: reed and denting; picks: "
                     "from crimp", "area covered"):
            self.assertIn(line, table)
        # 19 ends become 20 on a centimetre that was wider by a twentieth; of 18 picks 19 are counted after the wash.
        self.assertRegex(table, r"shrinks off the loom +5\.0 x \?  %")
        self.assertRegex(table, r"shrinks in the wash +\? x 5\.3  %")
        self.assertIn("Shrinkage is not modelled", table)

    def test_what_a_wash_does_to_cloth_is_not_known_until_it_is_counted(self):
        file = SAMPLES / "cloths/georgette.json"  # which nothing has pressed
        info = json.loads(self.run_program("info", file, "--json", "--resolution", 1))
        self.assertEqual(info["press"], 0)
        for system in ("ends", "picks"):
            self.assertEqual(info["setts"]["washed"][system], {"per_cm": None, "from": "not known"})
        table = self.run_program("info", file, "--resolution", 1)
        self.assertRegex(table, r"sett, washed +\? x \?  per cm, not known")
        self.assertNotIn("shrinks in the wash", table)

    def test_yarns_are_told_as_a_laboratory_measures_them(self):
        file = SAMPLES / "cloths/poplin.json"
        yarn, = json.loads(self.run_program("info", file, "--json", "--resolution", 1))["yarns"]
        self.assertAlmostEqual(yarn["count_tex"], 590.5 / 40, delta=1)
        self.assertTrue(3 < yarn["hairiness_h"] < 7, yarn)
        self.assertEqual(yarn["evenness_cv_percent"], 13.5)
        self.assertIn(f"hairiness H {yarn['hairiness_h']:.1f}, CVm 13.5 %",
                      self.run_program("info", file, "--resolution", 1))

    def test_a_blend_is_as_fine_as_its_fibres_are_on_average(self):
        fibres = [{"radius_um": 5, "density_g_cm3": 1.3}, {"radius_um": 12, "density_g_cm3": 1.5}]
        yarn = {"fibre": 0, "blend_fibre": 1, "blend_share": 0.4, "plies": 2, "fibres_per_ply": 30}
        file = self.fabric(yarns=[{"name": "warp", **yarn}, {"name": "weft", **yarn}], fibres=fibres)
        tex = [1e-3 * fibre["density_g_cm3"] * math.pi * fibre["radius_um"] ** 2 for fibre in fibres]
        second = 0.4 / tex[1] / (0.6 / tex[0] + 0.4 / tex[1])  # the share is one of mass
        for told in json.loads(self.run_program("info", file, "--json", "--resolution", 1))["yarns"]:
            self.assertAlmostEqual(told["count_tex"], 60 * ((1 - second) * tex[0] + second * tex[1]))

    def test_the_fabric_that_the_readme_shows_is_one_that_could_be_spun(self):
        text = re.search(r"```json\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL).group(1)
        (self.folder / "readme.json").write_text(text, encoding="utf-8")
        info = json.loads(self.run_program("info", "readme.json", "--json", "--resolution", 1))
        self.assertEqual(info["warnings"], [])
        self.assertEqual([yarn["name"] for yarn in info["yarns"]], ["indigo", "ecru"])
        for yarn, told in zip(info["yarns"], json.loads(text)["yarns"]):
            self.assertTrue(4 < yarn["hairiness_h"] < 7, yarn)
            self.assertGreater(yarn["evenness_cv_percent"], 0)
            self.assertTrue(told["migration"] > 0 and told["fibre_disorder_deg"] > 0, told)

    def test_a_yarn_that_is_more_even_than_chance_is_warned_of(self):
        yarns = [{"name": name, "fibre": 0, "fibres_per_ply": 100, "migration": 0.25, "evenness_cv_percent": cv}
                 for name, cv in (("warp", 10), ("weft", 12))]
        warning, = json.loads(self.run_program("info", self.fabric(yarns=yarns), "--json"))["warnings"]
        self.assertIn("A CVm of 10 % is more even than a spun yarn", warning)
        self.assertIn("its 100 fibres, laid at random, have 10.6 %", warning)

    def test_the_table_has_units(self):
        table = self.run_program("info", self.fabric())
        for word in ("small twill", "g/m2", "mm", "per cm", "ends x picks", "MB", "Yarn for a piece of 10 m x 150 cm"):
            self.assertIn(word, table)

    def test_a_draft_says_how_it_is_woven_and_what_was_wrong_in_its_file(self):
        self.run_program("convert", self.fabric(), "a.wif")
        text = self.bytes_of("a.wif").replace(b"Rising Shed=true\r\n", b"")
        (self.folder / "b.wif").write_bytes(text)
        info = json.loads(self.run_program("info", "b.wif", "--json", "--resolution", 1))
        self.assertEqual((info["ends"], info["shafts"], info["warp_up_cells"]), (4, 4, 8))
        self.assertEqual(info["draft"], {"by": "treadling", "rising_shed": True})
        self.assertIn("b.wif: [WEAVING] Rising Shed: It is not said whether the shed rises; it is taken as rising.", info["warnings"])
        self.assertIn("rising shed", self.run_program("info", "b.wif", "--resolution", 1))

    def test_a_piece_a_hundred_times_as_large_needs_eight_bytes_more_an_end_or_pick(self):
        infos = []
        for side in (30, 300):
            drape = {"kind": "flat", "width_mm": side, "height_mm": side}
            infos.append(json.loads(self.run_program("info", self.fabric(drape=drape), "--json")))
        small, large = infos
        threads = 27 * (small["ends_per_cm"] + small["picks_per_cm"])
        self.assertEqual(large["bricks"], small["bricks"])
        self.assertLessEqual(large["volume_bytes"] - small["volume_bytes"], 8 * threads)


main()
