"""The schema of fabric files is a schema, and what we call fabrics agrees with it."""

import copy
import json

import jsonschema

from harness import SAMPLES, CommandLineTest, main


class Schema(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.schema = json.loads(self.run_program("schema"))
        jsonschema.Draft202012Validator.check_schema(self.schema)
        self.validator = jsonschema.Draft202012Validator(self.schema)

    def test_every_sample_is_valid(self):
        samples = sorted(SAMPLES.glob("*.json"))
        self.assertGreater(len(samples), 5)
        for file in samples:
            errors = [error.message for error in self.validator.iter_errors(json.loads(file.read_text()))]
            self.assertEqual(errors, [], file.name)

    def test_what_is_refused_is_not_valid(self):
        good = json.loads((SAMPLES / "denim.json").read_text())
        for change in (
            lambda f: f.pop("loomlight_version"),
            lambda f: f["yarns"][0].update(plies=9),
            lambda f: f["yarns"][0].update(plies=1.5),
            lambda f: f["yarns"][0].update(layout="heaped"),
            lambda f: f["fibres"][0].update(absorption_per_mm=[1, 2]),
            lambda f: f["fibres"][0].update(absorption_per_mm={"primary": [1, 2, 3]}),
            lambda f: f["fibres"][0].update(absorption_per_mm={"bands": {"from_nm": 400, "step_nm": 10}}),
            lambda f: f["fibres"][0].update(absorption_per_mm={"bands": {"step": 10, "values": [1] * 40}}),
            lambda f: f["fibres"][0].update(absorption_per_mm={"dyes": [{"percent": 3}]}),
            lambda f: f.update(weave=["#x"]),
            lambda f: f.update(warp_sequence=[-1]),
        ):
            bad = copy.deepcopy(good)
            change(bad)
            self.assertFalse(self.validator.is_valid(bad))
            file = self.folder / "bad.json"
            file.write_text(json.dumps(bad))
            self.run_program("info", file, status=1)

    def test_the_list_for_people_has_every_key(self):
        keys = self.run_program("schema", "--keys")
        for key in ("loomlight_version: 1 to 1", "count_tex: 0.5 to 5000", "threading: list", "kind: flat | cylinder"):
            self.assertIn(key, keys)


if __name__ == "__main__":
    main()
