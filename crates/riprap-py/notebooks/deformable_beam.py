# %% [markdown]
# # A notched beam breaks
#
# A beam of deformable blocks on two pins, loaded in the middle, with a notch beside it. Blocks that are about to break are
# cut through the tip of the crack, so the crack need not follow the faces that were there. Builds on the first hour of the book.

# %%
import numpy as np

import riprap

# %% [markdown]
# ## The scenario
#
# 105 cubes of 30 mm, each of six tetrahedra, joined by brittle bonds. Two phases: the load comes to rest without breaking, then
# the crack grows, every step of it at rest (`kind = "static"`).

# %%
LENGTH, HEIGHT, CELL = 0.63, 0.15, 0.03
FORCE = 2700.0  # N


def text(*metres):
    return [f"{m:g} m" for m in metres]


def pin(place, **fixed):
    return {"on": {"nodes": {"min": text(place, 0, 0), "max": text(place, 0, CELL)}}, "fixed": fixed}


scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A notched beam breaks",
        "space": {"spatial": {"gravity": "0 m/s2"}},
        "materials": {"rock": {"density": "2500 kg/m3", "young": "27.4 GPa", "poisson": 0.25}},
        "interfaces": {
            "default": {
                "brittle_bond": {
                    "thickness": "0.3 mm",
                    "tension": "2 MPa",
                    "cohesion": "10 MPa",
                    "friction_angle": "30 deg",
                }
            }
        },
        "blocks": [
            {
                "name": "beam",
                "material": "rock",
                "grid": {"box": {"size": text(LENGTH, HEIGHT, CELL), "cell": f"{CELL:g} m"}},
                "mechanics": {"deformable": {}},
            }
        ],
        "notches": [{"box": {"min": text(0.21, 0, 0), "max": text(0.21, CELL, CELL)}}],
        "boundaries": [
            {"on": {"plane": "z-min"}, "roller": {}},
            {"on": {"plane": "z-max"}, "roller": {}},
            {
                "name": "plate",
                "on": {"block": "beam.95", "side": "y-max"},
                "traction": {"value": ["0 MPa", f"{-FORCE / CELL**2 / 1e6:.6g} MPa", "0 MPa"]},
            },
        ],
        "supports": [pin(0), pin(LENGTH, x=False)],
        "phases": [
            {"name": "bend", "kind": "static", "breaking": False, "until": {"unbalanced": 1e-5}},
            {
                "name": "break",
                "kind": "static",
                "cut": {"planes": 1, "along": "z", "anchor": "tip", "generations": 2},
                "iterations": 60000,
                "until": {"unbalanced": 1e-4},
            },
        ],
        "outputs": [
            {"frames": {"every": "4000 steps"}},
            {"history": {"name": "broken", "field": "model.broken_area", "every": "100 steps"}},
        ],
    }
)
print(scenario.check())

# %% [markdown]
# ## Bending
#
# Before anything breaks the largest tension can be compared with beam theory: at the section of the notch the moment is F/2 times the
# distance from the pin. The blocks are coarse and the tip concentrates stress, so only the order is the same.

# %%
run = scenario.run("beam.run", existing="replace", threads=2)
moment = 0.5 * FORCE * 0.21
beam_theory = 6 * moment / (CELL * (HEIGHT - CELL) ** 2)
bent = next(f for f in reversed(run.frames()) if f.phase == "bend")
tension = -bent.blocks["sigma3_compressive"].min()
print(f"beam theory over the notch {beam_theory / 1e6:.2f} MPa, largest mean stress of a block {tension / 1e6:.2f} MPa")
assert 0.3 < tension / beam_theory < 3

# %% [markdown]
# ## The crack
#
# Events tell which blocks were cut and which bonds broke; the crack surfaces are a series of their own (`cracks.pvd`).

# %%
events = run.events()
cuts = [e for e in events if e["event"] == "block_cut"]
bonds = [e for e in events if e["event"] == "bond_broken"]
tension_area = sum(e["area_tension"] for e in bonds)
shear_area = sum(e["area_shear"] for e in bonds)
print(f"{len(cuts)} cuts, {len(bonds)} bonds; broken by tension {1e4 * tension_area:.1f} cm2, by shear {1e4 * shear_area:.2f} cm2")
assert cuts and tension_area > 10 * shear_area
angles = [np.degrees(np.arctan2(abs(e["normal"][1]), abs(e["normal"][0]))) for e in cuts]
print("the planes lean by", ", ".join(f"{a:.0f}" for a in angles), "degrees from upright, towards the load")

# %%
run.plot("blocks", by="sigma3_compressive", exaggerate=200)
run.plot("stereonet")
run.plot("rose")
