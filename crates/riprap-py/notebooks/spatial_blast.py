# %% [markdown]
# # A charge under a free surface
#
# 2 kg of ammonium nitrate 2 m deep in bricks of 1 m. The bricks around the charge are split until the finest have its
# volume; the gas takes their place and pushes. Builds on the first hour of the book.

# %%
import numpy as np

import riprap

# %% [markdown]
# ## The scenario
#
# Sides and bottom let waves out (`viscous`, `held`); the joints carry the weight of the rock from the start (`in_situ`).

# %%
side = [{"on": {"plane": plane}, "viscous": {}} for plane in ("x-min", "x-max", "y-min", "y-max")]
surface = {"field": "block.velocity", "along": [0, 0, 1], "every": "10 us"}
scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A charge under a free surface",
        "space": {"spatial": {"gravity": "9.81 m/s2"}},
        "materials": {"rock": {"density": "2400 kg/m3", "young": "18 GPa", "poisson": 0.25}},
        # Dashpots on sliding points too, as in the source, whose blasts were calibrated with them.
        "interfaces": {"default": {"cohesion": "4.16 MPa", "friction_angle": "30 deg", "dashpots": "closed"}},
        "blocks": [
            {
                "name": "rock",
                "material": "rock",
                "grid": {
                    "box": {"size": ["8 m", "8 m", "4 m"], "cell": "1 m", "corner": ["-4 m", "-4 m", "-4 m"]}
                },
            }
        ],
        "explosives": {
            "ammonium_nitrate": {
                "density": "1000 kg/m3",
                "detonation_velocity": "4000 m/s",
                "heat_of_explosion": "3688 kJ/kg",
            }
        },
        "sources": {
            "charge": {
                "gas_cavity": {"centre": ["0 m", "0 m", "-2 m"], "mass": "2 kg", "explosive": "ammonium_nitrate"}
            }
        },
        "refine": [{"octree": {"around": "charge"}}],
        "in_situ": {"gravity_k0": {"k0": 0.3333}},
        "boundaries": [{"on": {"plane": "z-min"}, "held": {}}, *side],
        "phases": [{"name": "blast", "until": {"time": "1 ms"}}],
        "outputs": [
            {"frames": {"every": "0.5 ms"}},
            {"history": {"name": "charge.pressure", "field": "cavity.pressure", "of": "charge", "every": "5 us"}},
            {"history": {"name": "heave", "at_point": ["0.1 m", "0.1 m", "-0.1 m"], **surface}},
        ],
    }
)
print(scenario.check())

# %% [markdown]
# ## The run
#
# A callback is called about ten times a second; it could stop the run by returning False. Ctrl-C stops it with a
# checkpoint.

# %%
speeds = []
run = scenario.run("blast.run", existing="replace", callback=lambda p: speeds.append(p.fastest[1]))
histories = run.histories()
_, pressure = histories.series("charge.pressure")
time, heave = histories.series("heave")
arrival = time[np.argmax(heave > 0.5 * heave.max())]
print(f"pressure {pressure[0] / 1e9:.2f} GPa -> {pressure[-1] / 1e9:.2f} GPa")
print(f"the surface has half its speed after {1e3 * arrival:.2f} ms, at most {heave.max():.2f} {heave.unit}")

# %% [markdown]
# A P wave needs 2 m / c for the way, with rho c^2 = E (1 - nu) / ((1 + nu)(1 - 2 nu)). Two bricks of 1 m blur it: the
# surface begins to move before, and the finer the bricks the sharper the front.

# %%
speed_of_p = np.sqrt(18e9 * 0.75 / (1.25 * 0.5) / 2400)
print(f"c = {speed_of_p:.0f} m/s, 2 m take {2e3 / speed_of_p:.2f} ms")
assert pressure[-1] < 0.6 * pressure[0] and heave.max() > 0.1

# %% [markdown]
# ## Fields in space
#
# `frame.blocks` are arrays; `frame.to_pyvista()` makes a grid of hexahedra and polyhedra for pyvista.

# %%
last = run.frame(-1)
velocity = last.blocks["velocity"]
print(f"{last.n_blocks} blocks, fastest {np.linalg.norm(velocity, axis=1).max():.1f} {velocity.unit}")
levels, counts = np.unique(last.blocks["level"], return_counts=True)
for level, count in zip(levels, counts):
    print(f"level {level:.0f}: {count} blocks, edge about {1 / 2**level:g} m")

# %%
run.plot("cavity")
run.plot("section", by="velocity", at="0.1 m", vectors="velocity")
