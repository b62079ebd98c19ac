# %% [markdown]
# # Draw control
#
# Broken rock lies in a bunker above two drawpoints. A script draws from them: every so many steps it takes away the blocks that have come
# through a drawpoint, up to what it may take, and dumps as many new ones from above. That is what `Simulation.change` and
# `Simulation.add_block` are for: keys of a phase, and blocks that were not there, at any step.
#
# Open it in any editor that knows the percent format (VS Code, PyCharm, Jupyter with jupytext), or run it:
# `python draw_control.py`.

# %%
import numpy as np

import riprap


def wall(name, size, corner):
    return {
        "name": name,
        "material": "rock",
        "rectangle": {"size": [f"{s} m" for s in size], "corner": [f"{c} m" for c in corner]},
    }


scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "Broken rock above two drawpoints",
        "space": {"planar": {"gravity": ["0 m/s2", "-9.81 m/s2"]}},
        "materials": {"rock": {"density": "2600 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": "20 MPa/m", "friction_angle": "20 deg", "damping_ratio": 0.4}},
        "blocks": [
            wall("west", (0.5, 5), (-3.5, -0.5)),
            wall("east", (0.5, 5), (3, -0.5)),
            wall("middle", (1, 0.5), (-0.5, -0.5)),
            wall("sill west", (0.7, 0.5), (-3, -0.5)),
            wall("sill east", (0.7, 0.5), (2.3, -0.5)),
            wall("gate west", (1.8, 0.5), (-2.3, -0.5)),
            wall("gate east", (1.8, 0.5), (0.5, -0.5)),
            {
                "name": "ore",
                "material": "rock",
                "pour": {
                    "region": [["-2.95 m", "0.02 m"], ["2.95 m", "4 m"]],
                    "count": 60,
                    "size": ["0.35 m", "0.5 m"],
                    "seed": 4,
                },
            },
        ],
        "groups": {"frame": {"blocks": ["west", "east", "middle", "sill west", "sill east", "gate west", "gate east"]}},
        "supports": [{"on": {"group": "frame"}, "fixed": {}}],
        "phases": [
            {"name": "settle", "until": {"time": "1 s"}},
            {"name": "draw", "until": {"time": "4 s"}},
        ],
    }
)

# %% [markdown]
# ## The rules of drawing
#
# When the rock has settled both gates are taken away. A stone that is a metre below the sill is in the drift: it is loaded and gone. From each
# drawpoint six stones may be drawn; then it is closed again, by fixing what lies in its opening. For each stone that is gone another one comes down
# the chute, as soon as the one before it has made room: a block in the way is a `ValueError` with its name and the depth, and changes nothing.

# %%
LIMIT = 6
CHUTES = (-1.2, 0.0, 1.2)
drawn = {"west": [], "east": []}
closed = set()
dumped = []


def refill(sim):
    while len(dumped) < sum(len(names) for names in drawn.values()):
        middle = np.array([CHUTES[len(dumped) % len(CHUTES)], 3.5])
        corners = middle + 0.2 * np.array([(-1, -1), (1, -0.8), (0.9, 1), (-0.7, 0.9)])
        name = f"refill.{len(dumped) + 1}"
        try:
            mass = sim.add_block(name, corners, material="rock", groups="ore", velocity=(0, -1))
        except ValueError as wrong:
            if "inside block" not in str(wrong):
                raise
            return
        dumped.append(mass)


def draw(sim):
    if sim.phase != "draw":
        return
    names = sim.names
    frame = sim.frame()
    numbers = np.asarray(frame.blocks["block"]).astype(int)
    if "gate west" in {names[n] for n in numbers}:
        sim.change({"remove": ["gate west", "gate east"]})
        return
    centres = {names[n]: np.asarray(frame.corners(k)).mean(axis=0) for k, n in enumerate(numbers)}
    gone, stopped = [], []
    for name, (x, y, _) in centres.items():
        side = "west" if x < 0 else "east"
        if not name.startswith(("ore", "refill")):
            continue
        if y < -1:
            gone.append(name)
            drawn[side].append(name)
        elif len(drawn[side]) >= LIMIT and side not in closed and -0.6 < y < 0.5:
            stopped.append((side, name))
    if gone:
        sim.change({"remove": gone})
    if stopped:
        sim.change({"fix": [name for _, name in stopped if name not in gone]})
        closed.update(side for side, _ in stopped)
    refill(sim)


def go():
    for side in drawn:
        drawn[side].clear()
    closed.clear()
    dumped.clear()
    with riprap.Simulation(scenario, threads=1) as sim:
        sim.run(draw, every=200)
        ore = sim.value("group.blocks", of="ore").value
        mass, recovery = (sim.value(f"group.{name}", of="ore").value for name in ("drawn_mass", "recovery"))
        return ore, sim.state_hash, sim.value("energy.residual_relative").value, mass, recovery


left, state, residual, mass, recovery = go()
total = {side: len(names) for side, names in drawn.items()}
print(f"drawn {total}, dumped {len(dumped)} with {sum(dumped):.0f} kg/m, {left:.0f} stones are left, ledger {residual:.1e}")
print(f"drawn mass {mass:.0f} kg/m, {recovery:.0%} of all that was there or was dumped")
assert mass > 0 and 0 < recovery < 1
assert total["west"] >= LIMIT and total["east"] >= LIMIT and residual < 0.01
assert len(dumped) >= LIMIT and left == 60 - sum(total.values()) + len(dumped)

# %% [markdown]
# ## Twice the same
#
# The same script makes the same changes at the same steps, and the same changes give the same bits.

# %%
assert go()[1] == state
