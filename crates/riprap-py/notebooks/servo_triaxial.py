# %% [markdown]
# # A triaxial test with a servo
#
# A prism of rock with one joint that dips 60 degrees stands between six platens of which two are servo-controlled: they move so that the
# confining stress stays as it is while the upper platen comes down. The prism fails along the joint at
# `sigma_1 = sigma_3 tan(60)/tan(60 - phi)` (Jaeger), three times the confinement for a friction angle of 30 degrees.
#
# The servo is code in the loop: a callback reads what the platens bear and gives them their next velocity.
#
# Open it in any editor that knows the percent format (VS Code, PyCharm, Jupyter with jupytext), or run it:
# `python servo_triaxial.py`.

# %%
import math

import numpy as np

import riprap

CONFINEMENT = 1e6  # Pa
FRICTION = math.radians(30)
DIP = math.radians(60)
STIFFNESS = 20e9  # Pa/m
HALF, HEIGHT = 0.05, 0.2  # m
TALL = 2 * HALF * math.tan(DIP)  # m, of a side platen: as far as the joint reaches
SIDE = 2 * HALF * TALL  # m2 under it

# %% [markdown]
# ## The scenario
#
# Platens are blocks whose supports prescribe a velocity: the script changes it. Between rock and steel there is no friction.


# %%
def prism(low, high):
    """Corners of a prism between z = low(x) and z = high(x)."""
    ends = [(x, y) for x in (-HALF, HALF) for y in (-HALF, HALF)]
    return [[f"{x} m", f"{y} m", f"{z(x)} m"] for z in (low, high) for x, y in ends]


def platen(name, size, centre):
    return {
        "name": name,
        "material": "steel",
        "brick": {"size": [f"{s} m" for s in size], "centre": [f"{c} m" for c in centre]},
    }


def driven(name):
    still = {"constant": "0 m/s"}
    spin = {"constant": "0 rad/s"}
    velocity = {"x": still, "y": still, "z": still, "spin_x": spin, "spin_y": spin, "spin_z": spin}
    return {"name": name, "on": {"block": name}, "motion": {"velocity": velocity}}


def joint(x):
    return HEIGHT / 2 + math.tan(DIP) * x


stiffness = {"normal_stiffness": f"{STIFFNESS} Pa/m", "shear_stiffness": f"{STIFFNESS / 2} Pa/m"}
scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A jointed prism between platens",
        "space": {"spatial": {"gravity": "0 m/s2"}},
        "materials": {
            "rock": {"density": "2600 kg/m3", "young": "20 GPa", "poisson": 0.25},
            "steel": {"density": "7800 kg/m3", "young": "200 GPa", "poisson": 0.3},
        },
        "interfaces": {
            "default": {**stiffness, "friction_angle": f"{FRICTION} rad"},
            "smooth": {"between": ["rock", "steel"], **stiffness, "friction_angle": "0 deg"},
            "apart": {"between": ["steel", "steel"], **stiffness, "friction_angle": "0 deg"},
        },
        "blocks": [
            {"name": "lower", "material": "rock", "polyhedron": {"vertices": prism(lambda x: 0.0, joint)}},
            {"name": "upper", "material": "rock", "polyhedron": {"vertices": prism(joint, lambda x: HEIGHT)}},
            platen("base", (0.14, 0.14, 0.02), (0, 0, -0.01)),
            platen("top", (0.14, 0.14, 0.02), (0, 0, HEIGHT + 0.01)),
            platen("left", (0.02, 2 * HALF, TALL), (-HALF - 0.01, 0, HEIGHT / 2)),
            platen("right", (0.02, 2 * HALF, TALL), (HALF + 0.01, 0, HEIGHT / 2)),
        ],
        "supports": [driven(name) for name in ("base", "top", "left", "right")],
        "phases": [{"name": "test", "until": {"time": "0.5 s"}, "damping": {"local": 0.5}}],
    }
)

# %% [markdown]
# ## The servo
#
# Each platen goes a share of the way towards the stress that it should have in the time until it is looked at again, and a smaller share for
# what it has missed so far, so that it keeps up with a joint that slides. The upper one becomes a ram when the confinement stands.

# %%
EVERY, SHARE, MEMORY = 10, 0.2, 0.02  # steps, 1, 1
RAM, LIMIT = 1e-3, 0.05  # m/s
missed = {"left": 0.0, "right": 0.0, "top": 0.0}
log = []


def servo(sim):
    def force(name, axis):
        return sim.value(f"support.force.{axis}", of=name).value

    def speed(name, force, area):
        missing = CONFINEMENT - force / area
        missed[name] += missing
        way = (SHARE * missing + MEMORY * missed[name]) / STIFFNESS
        return float(np.clip(way / (EVERY * sim.dt), -LIMIT, LIMIT))

    end = 4 * HALF**2
    left, right, top = force("left", "x"), -force("right", "x"), -force("top", "z")
    sim.steer("left", velocity=(speed("left", left, SIDE), 0, 0))
    sim.steer("right", velocity=(-speed("right", right, SIDE), 0, 0))
    down = speed("top", top, end) if sim.time < 0.06 else RAM
    sim.steer("top", velocity=(0, 0, -down))
    log.append((sim.time, 0.5 * (left + right) / SIDE, top / end))


with riprap.Simulation(scenario, threads=1) as sim:
    sim.run(servo, every=EVERY)
    state = sim.state_hash

# %% [markdown]
# ## What came of it

# %%
time, sigma_3, sigma_1 = np.array(log).T
loaded = time > 0.08
peak = sigma_1[loaded].max()
expected = CONFINEMENT * math.tan(DIP) / math.tan(DIP - FRICTION)
print(f"confinement {sigma_3[loaded].mean() / 1e6:.3f} MPa, asked for {CONFINEMENT / 1e6:.3f} MPa")
print(f"strength {peak / 1e6:.3f} MPa, Jaeger {expected / 1e6:.3f} MPa")
assert abs(sigma_3[loaded].mean() / CONFINEMENT - 1) < 0.03
assert abs(peak / expected - 1) < 0.05
