"""Asks the public validators that are here about what was handed over: check_formats.py FOLDER NAME [U3M_SCHEMA].

The schema of U3M 1.1 (BSD-3, its owners publish it) by python3-jsonschema; MaterialX by its own library, the Python
package MaterialX, which Debian does not have; glTF by Khronos' gltf_validator, which it does not have either, and by
Khronos' schema of glTF 2.0 (all but its extensions) in the Python package trimesh. What is not here is said, and is no
failure; a schema that was named and cannot be read is one."""

import json
import pathlib
import shutil
import struct
import subprocess
import sys


def say(what, verdict):
    print(f"{verdict}: {what}", flush=True)
    return verdict != "FAILED"


def check_u3m(file, schema):
    if schema is None:
        return say("the schema of U3M (none was given)", "skipped")
    import jsonschema

    with open(schema, encoding="utf-8") as rules, open(file, encoding="utf-8") as text:
        rules, cloth = json.load(rules), json.load(text)
    wrong = list(jsonschema.validators.validator_for(rules)(rules).iter_errors(cloth))
    for one in wrong[:5]:
        print(f"  {'/'.join(map(str, one.absolute_path))}: {one.message[:200]}")
    return say(f"{file.name} by the schema of U3M", "FAILED" if wrong else "passed")


def check_materialx(file):
    try:
        import MaterialX
    except ImportError:
        return say("MaterialX' library (not here, PyPI: MaterialX)", "skipped")
    document = MaterialX.createDocument()
    MaterialX.readFromXmlFile(document, str(file))
    library = MaterialX.createDocument()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), MaterialX.getDefaultDataSearchPath(), library)
    document.setDataLibrary(library)
    valid, wrong = document.validate()
    if not valid:
        print(f"  {wrong[:500]}")
    missing = [node.getName() for node in document.getNodes() if node.getNodeDef() is None]
    if missing:
        print(f"  nodes that the standard library does not know: {', '.join(missing)}")
    return say(f"{file.name} by MaterialX {MaterialX.getVersionString()}",
               "passed" if valid and not missing else "FAILED")


def check_gltf_schema(file):
    try:
        import jsonschema
        from trimesh.exchange.gltf import get_schema
    except ImportError:
        return say("Khronos' schema of glTF (not here, PyPI: trimesh)", "skipped")
    content = file.read_bytes()
    length, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON", kind
    wrong = list(jsonschema.Draft4Validator(get_schema()).iter_errors(json.loads(content[20:20 + length])))
    for one in wrong[:5]:
        print(f"  {'/'.join(map(str, one.absolute_path))}: {one.message[:200]}")
    return say(f"{file.name} by Khronos' schema of glTF 2.0", "FAILED" if wrong else "passed")


def check_gltf(file):
    validator = shutil.which("gltf_validator")
    if validator is None:
        return say("Khronos' gltf_validator (not here)", "skipped")
    done = subprocess.run([validator, "--stdout", file], stdout=subprocess.PIPE, check=False)
    issues = json.loads(done.stdout)["issues"]
    for one in issues["messages"][:5]:
        print(f"  {one['pointer']}: {one['message']}")
    return say(f"{file.name} by Khronos' validator", "FAILED" if issues["numErrors"] else "passed")


def main(folder, name, schema=None):
    folder = pathlib.Path(folder)
    verdicts = [check_u3m(folder / f"{name}.u3m", schema)]
    for side in ("", "_back"):
        verdicts.append(check_materialx(folder / f"{name}{side}.mtlx"))
        verdicts.append(check_gltf_schema(folder / f"{name}{side}.glb"))
        verdicts.append(check_gltf(folder / f"{name}{side}.glb"))
    return 0 if all(verdicts) else 1


sys.exit(main(*sys.argv[1:]))
