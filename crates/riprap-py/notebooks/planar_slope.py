# %% [markdown]
# # A jointed slope in the plane
#
# Two sets of joints cut a slope of 12 m. It settles under its own weight with rough joints; then the joints get their
# true friction, and either it stands or it slides. Builds on the first hour of the book.
#
# Open it in any editor that knows the percent format (VS Code, PyCharm, Jupyter with jupytext), or run it:
# `python planar_slope.py`.

# %%
import numpy as np

import riprap

# %% [markdown]
# ## The scenario
#
# A scenario is a dictionary: the tables of the TOML language, quantities as texts with units. `print(scenario.text)`
# shows the TOML, and `riprap.explain("blocks.cut.joint_sets.spacing")` says what a key means.

# %%
scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A jointed rock slope",
        "space": {"planar": {"gravity": ["0 m/s2", "-9.81 m/s2"]}},
        "materials": {"rock": {"density": "2600 kg/m3"}},
        "interfaces": {
            "default": {
                "normal_stiffness": "2 GPa/m",
                "shear_stiffness": "1 GPa/m",
                "friction_angle": "45 deg",
                "damping_ratio": 0.3,
            }
        },
        "blocks": [
            {
                "name": "base",
                "material": "rock",
                "polygon": {
                    "points": [
                        ["-14 m", "-3 m"], ["16 m", "-3 m"], ["16 m", "16 m"],
                        ["14 m", "16 m"], ["14 m", "0 m"], ["-14 m", "0 m"],
                    ]
                },
            },
            {
                "name": "slope",
                "material": "rock",
                "cut": {
                    "region": [["0 m", "0 m"], ["14 m", "0 m"], ["14 m", "12 m"], ["6 m", "12 m"]],
                    "smallest_edge": "0.1 m",
                    "seed": 5,
                    "joint_sets": [
                        {"dip": "30 deg", "spacing": "2.4 m", "spacing_scatter": "0.2 m", "angle_scatter": "1 deg"},
                        {"dip": "105 deg", "spacing": "2.6 m", "spacing_scatter": "0.3 m", "offset": "0.5 m"},
                    ],
                },
            },
        ],
        "supports": [{"on": {"block": "base"}, "fixed": {}}],
        "phases": [
            {"name": "settle", "kind": "static", "until": {"unbalanced": 1e-3, "steps": 20000}},
            {
                "name": "stand_or_fall",
                "reset": ["velocities", "displacements"],
                "until": {"time": "0.45 s"},
                "safety": 0.4,
                "interfaces": {"default": {"friction_angle": "22 deg"}},
            },
        ],
        "outputs": [
            {"frames": {"every": "0.1 s"}},
            {"history": {"name": "largest move", "field": "group.max_displacement", "of": "slope", "every": "10 ms"}},
        ],
    }
)
report = scenario.check()
print(report)

# %% [markdown]
# ## One run

# %%
run = scenario.run("slope.run", existing="replace")
moved = run.histories()["largest move"]
print(f"at 22 degrees the slope moves {moved[-1]:.3f} {moved.unit} in 0.45 s")
run.plot("blocks", by="displacement", exaggerate=1.0)

# %% [markdown]
# Fields are NumPy arrays: which blocks carry the motion?

# %%
last = run.frame(-1)
speed = np.linalg.norm(last.blocks["velocity"], axis=1)
print(f"{np.count_nonzero(speed > 0.1)} of {last.n_blocks} blocks are faster than 0.1 m/s")

# %% [markdown]
# ## A sweep over the friction
#
# Each case runs on a thread of its own. With pandas the table is a data frame.

# %%
sweep = riprap.sweep(
    scenario,
    "slope.sweep",
    over={"phases.1.interfaces.default.friction_angle": ["22 deg", "40 deg"]},
    existing="replace",
)
print(sweep.table())
by_friction = [run.histories()["largest move"][-1] for run in sweep.values()]
assert by_friction[0] > 10 * by_friction[1], by_friction

# %% [markdown]
# ## Step by step
#
# A simulation can be advanced as far as wanted and looked at in between. Here: how long until the slope has moved
# 10 cm?

# %%
with riprap.Simulation(scenario) as sim:
    while sim.phase == "settle":
        sim.advance(steps=200)
    begin = sim.time
    while sim.histories()["largest move"].value < 0.1 and sim.advance(time=0.01):
        pass
    print(f"0.1 m after {sim.time - begin:.2f} s, kinetic energy {sim.energy()['kinetic'].value:.0f} J/m")
