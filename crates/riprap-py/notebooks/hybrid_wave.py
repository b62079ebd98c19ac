# %% [markdown]
# # Rigid where only the wave counts, deformable where stress does
#
# A wave runs along a bar of rigid blocks and passes into deformable ones. With matched bonds the joint between the two kinds is
# nearly invisible; with soft bonds in the deformable part it is a mirror. Builds on the first hour of the book.

# %%
import numpy as np

import riprap

# %% [markdown]
# ## The scenario
#
# Bonds of 10 mm between cubes of 1 m carry the stiffness of the rock in both halves.

# %%
rollers = [
    {"name": side, "on": {"group": "near", "side": side}, "roller": {}} for side in ("y-min", "y-max", "z-min", "z-max")
]
FREQUENCY, WAVES = 237.17, 4
LAST = WAVES / FREQUENCY
packet = (
    f"0.25*(1 + ({LAST:.7f} - t)/abs({LAST:.7f} - t))*(1 - cos(2*pi*{FREQUENCY}*t/{WAVES}))*sin(2*pi*{FREQUENCY}*t)"
)
scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A wave passes from rigid to deformable blocks",
        "space": {"spatial": {"gravity": "0 m/s2", "kinematics": "small"}},
        "materials": {
            "rock": {"density": "2500 kg/m3", "young": "30 GPa", "poisson": 0.25},
            "other": {"density": "2500 kg/m3", "young": "30 GPa", "poisson": 0.25},
        },
        "interfaces": {
            "default": {
                "elastic": True,
                "damping_ratio": 0,
                "brittle_bond": {"thickness": "10 mm", "elastic": True},
            }
        },
        "blocks": [
            {
                "name": "far",
                "material": "rock",
                "grid": {"box": {"size": ["60 m", "1 m", "1 m"], "cell": "1 m"}},
            },
            {
                "name": "near",
                "material": "other",
                "grid": {
                    "box": {"size": ["60 m", "1 m", "1 m"], "cell": "1 m", "corner": ["60 m", "0 m", "0 m"]}
                },
                "mechanics": {"deformable": {}},
            },
        ],
        "boundaries": [
            *rollers,
            {"name": "source", "on": {"plane": "x-min"}, "moved": {"velocity": {"x": {"formula": packet}}}},
            {"name": "end", "on": {"plane": "x-max"}, "viscous": {}},
        ],
        "phases": [{"name": "run", "until": {"time": "40 ms"}}],
        "outputs": [
            {"frames": {"every": "2 ms"}},
            {"history": {"name": "rigid", "field": "block.velocity.x", "of": "far.20", "every": "0.1 ms"}},
            {"history": {"name": "deformable", "field": "block.velocity.x", "of": "near.20", "every": "0.1 ms"}},
        ],
    }
)

# %% [markdown]
# ## How much comes back
#
# At `far.20` the packet has passed after 22.2 ms; what is there later comes from the junction.


# %%
def amplitudes(run):
    """Largest velocities of the packet before and behind the junction, and of what comes back."""
    histories = run.histories()
    time, rigid = histories.series("rigid")
    _, deformable = histories.series("deformable")
    later = time > 24e-3
    return np.abs(rigid[~later]).max(), np.abs(deformable).max(), np.abs(rigid[later]).max()


run = scenario.run("wave.run", existing="replace", threads=1)
before, behind, back = amplitudes(run)
print(f"{before:.3f} m/s goes in, {behind:.3f} m/s goes on, {1e3 * back:.1f} mm/s comes back")
assert abs(behind / before - 1) < 0.05 and back < 0.02 * before

# %% [markdown]
# A deformable half four times softer has half the impedance: (1 - 1/2) / (1 + 1/2) = 1/3 of the amplitude comes back.

# %%
changed = riprap.Scenario(scenario.text, set={"materials.other.young": "7.5 GPa"})
softer = changed.run("softer.run", existing="replace", threads=1)
before, behind, back = amplitudes(softer)
print(f"softer: {back / before:.3f} of it comes back, 1/3 expected")
assert abs(back / before - 1 / 3) < 0.05

# %% [markdown]
# ## Stress in the deformable half
#
# A plane wave of particle speed v carries the stress rho c v.

# %%
speed = np.sqrt(30e9 * 0.75 / (1.25 * 0.5) / 2500)
peak = max(np.abs(frame.blocks["sigma1_compressive"][60:]).max() for frame in run.frames())
print(f"rho c v = {2500 * speed * 1.0 / 1e6:.2f} MPa, largest in the frames {peak / 1e6:.2f} MPa")
assert 0.7 < peak / (2500 * speed) < 1.1
run.plot("histories")
