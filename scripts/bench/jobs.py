"""What the benchmark runs: {name of the job: words for build/rc2}."""

MODELS = "/usr/share/assimp/models"
SCENES = {
    "room": "sw/scene/room.dae",
    "duck": f"{MODELS}/Collada/duck.dae",
    "house": f"{MODELS}/IFC/AC14-FZK-Haus.ifc",
    "engine": f"{MODELS}/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
    "suzanne": f"{MODELS}/BLEND/SuzanneSubdiv_252.blend",
}
# With a seed, which is the benchmark's.
GENERATED = {"shells": "shells:5", "dust": "dust:1"}
FEW = ("room", "duck", "shells")


def jobs(seed, full):
    scenes = {**SCENES, **{name: f"{scene}:{seed}" for name, scene in GENERATED.items()}}
    lights = 6 if full else 3
    sides = (16, 32, 64, 128, 256)
    all_jobs = {}

    def add(sweep, command, name, n, *words):
        suffix = "".join(f"-{word}" for word in words if not word.startswith("--"))
        all_jobs[f"{sweep}-{name}-{n}{suffix}"] = [command, scenes[name], "--n", str(n), "--lights", str(lights), *words]

    for name in scenes:
        for n in sides:
            if n == 256 and name not in FEW and not full:
                continue
            add("size", "measure", name, n, "--reach", "1,2")
            add("peers", "peers", name, n)
        # The array as it was built: f = 4, L up to 2n.
        add("rtl", "measure", name, 16, "--machine", "rtl,cycle", "--fraction-bits", "4")
    for name in scenes if full else FEW:
        for n in (64, 256) if full else (64,):
            add("reach", "measure", name, n, "--reach", "0.25,0.5,1,1.5,2,4,8")
            for f in ("0", "2", "4", "8"):
                add("fraction", "measure", name, n, "--fraction-bits", f)
            for rule in ("naive", "supercover", "half", "blindee"):
                add("rule", "measure", name, n, "--rule", rule)
            for bits in ("4", "6", "8", "10", "12"):
                add("width", "measure", name, n, "--coefficient-bits", bits, "--machine", "golden")
            add("skip", "measure", name, n, "--machine", "cycle", "--skip", "on,off", "--reach", "1,2")
        for mode in ("fast", "thesis"):
            add("queue", "measure", name, 64, "--machine", "cycle", "--light-rule", "thesis", "--mode", mode,
                "--fa", "1,2,4,8,16")
    return all_jobs
