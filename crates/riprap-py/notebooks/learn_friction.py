# %% [markdown]
# # A learning loop over friction
#
# A block on a slope was seen to slide a certain way in half a second, to within two millimetres. Which friction angle does its joint have? A loop asks the model: each
# trial lowers the friction by code and reads the slip. What the trials have told so far is held by a Gaussian process, and the next trial is where the answer
# is most likely: a handful of runs in place of a sweep, with a standard deviation at the end.
#
# Open it in any editor that knows the percent format (VS Code, PyCharm, Jupyter with jupytext), or run it: `python learn_friction.py`.

# %%
import numpy as np

import riprap

SLOPE = 35.0  # deg
HIDDEN = 17.3  # deg: what the loop must find
SURVEY = 2e-3  # standard deviation of the observation, m
level = {"rotate": {"angle": f"-{SLOPE} deg", "about": ["0 m", "0 m"]}, "material": "rock"}
scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A block on a slope",
        "space": {"planar": {"gravity": ["0 m/s2", "-9.81 m/s2"]}},
        "materials": {"rock": {"density": "2600 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": "1 GPa/m", "friction_angle": "45 deg", "damping_ratio": 0.5}},
        "blocks": [
            {"name": "slope", "rectangle": {"size": ["8 m", "0.5 m"], "corner": ["-1 m", "-0.5 m"]}, **level},
            {"name": "block", "rectangle": {"size": ["1 m", "0.5 m"], "corner": ["-0.5 m", "0 m"]}, **level},
        ],
        "supports": [{"on": {"block": "slope"}, "fixed": {}}],
        "phases": [{"name": "lie and slide", "until": {"time": "0.8 s"}}],
    }
)
runs = []


def slip(angle):
    """How far the block slides in half a second, m, once its friction angle (deg) has come down from 45 deg."""
    with riprap.Simulation(scenario, threads=1) as sim:
        sim.advance(time=0.2)
        start = sim.value("block.displacement", of="block").value
        sim.set_interface("default", friction_angle=f"{angle} deg")
        sim.advance(time=0.5)
        runs.append(angle)
        return sim.value("block.displacement", of="block").value - start


observed = slip(HIDDEN)
runs.clear()

# %% [markdown]
# ## The loop
#
# The Gaussian process (squared exponential, 8 deg wide) tells the slip of an angle that was not tried, with its variance; with that of the survey it
# gives the likelihood of each angle. The next trial is at the mean of the posterior, until the model adds little to the error of the survey.

# %%
angles = np.linspace(5, 34, 5801)


def kernel(one, other):
    return np.exp(-0.5 * ((one[:, None] - other[None, :]) / 8.0) ** 2)


def learnt(tried, slips):
    """Mean and variance of the slip at all angles."""
    tried, slips = np.array(tried), np.array(slips)
    middle, scale = slips.mean(), max(slips.std(), 0.1)
    own = kernel(tried, tried) + 1e-8 * np.eye(len(tried))
    across = kernel(angles, tried)
    mean = middle + across @ np.linalg.solve(own, slips - middle)
    variance = 1 - np.einsum("ij,ji->i", across, np.linalg.solve(own, across.T))
    return mean, scale**2 * np.maximum(variance, 0)


tried = [8.0, 20.0, 32.0]
slips = [slip(angle) for angle in tried]
for _ in range(10):
    mean, variance = learnt(tried, slips)
    spread = variance + SURVEY**2
    weight = np.exp(-0.5 * (observed - mean) ** 2 / spread) / np.sqrt(spread)
    weight /= weight.sum()
    best = float((weight * angles).sum())
    deviation = float(np.sqrt((weight * (angles - best) ** 2).sum()))
    print(f"after {len(tried)} runs: {best:.3f} +- {deviation:.3f} deg")
    if np.sqrt(variance[np.argmin(abs(angles - best))]) < 0.2 * SURVEY and len(tried) > 3:
        break
    tried.append(round(best, 4))
    slips.append(slip(tried[-1]))

# %% [markdown]
# ## What it has found
#
# The slip of a rigid block is g (sin b - cos b tan phi) t^2/2: two millimetres are worth as much friction as its slope says.

# %%
g, t = 9.81, 0.5
slope, phi = np.radians(SLOPE), np.radians(HIDDEN)
worth = SURVEY / (0.5 * g * t**2 * np.cos(slope) / np.cos(phi) ** 2)
print(f"found {best:.3f} deg after {len(runs)} runs, hidden {HIDDEN} deg; the survey alone leaves {np.degrees(worth):.3f} deg")
assert abs(best - HIDDEN) < 0.1, "the hidden angle to a tenth of a degree"
assert len(runs) <= 10 and abs(deviation - np.degrees(worth)) < 0.5 * np.degrees(worth)
assert slip(tried[-1]) == slips[-1], "the same trial gives the same bits"
