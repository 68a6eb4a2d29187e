"""heyoka_model.py RUNS.csv CASE.json... : what heyoka takes for the cases of `bentur_compare`, one row a tolerance.

The equations of equations.h as expressions that heyoka compiles: modal coordinates y = (Ω q, q̇), divided by a scale so
that one absolute tolerance fits all; a_g linear from breakpoint to breakpoint, its two coefficients parameters of the
stepper, set anew for each segment. Contact is a parameter for each point, 0 or 1, changed by the terminal event at which
its opening passes zero; the largest force is looked up in the step's Taylor polynomial where the opening turns. Two
steppers take turns, so that nothing of contact is computed while nobody touches.

Timed is the integration (processor time), not the compilation of the steppers. heyoka.csv beside RUNS.csv says how long
that takes, and `calls`, what the same calls from and to Python take by themselves. See bench/README.md.
"""

import json
import pathlib
import sys
import time

import heyoka
import numpy as np

TOLERANCES = [10.0**-i for i in range(1, 14)]  # heyoka takes nothing from them but the order: no need for half decades
CAP = 3.0  # a setting that takes longer is the last [s]
COMPILATION_CAP = 30.0  # likewise where its steppers take longer to compile [s]
WANTED = 1e-10  # relative error of the peak force at which the search ends, two tolerances in a row
BUDGET = 0.2  # for the repeats of one setting [s]
COOLDOWN = 1e-12  # in which an event is not found again; heyoka's own grows with the tolerance and misses contacts [s]


class Building:
    """Natural frequencies, damping, load and shapes of the modes, mass-normalised."""

    def __init__(self, matrices):
        mass, stiffness, damping = (np.array(matrices[key]) for key in ("mass", "stiffness", "damping"))
        inverse = np.linalg.inv(np.linalg.cholesky(mass))
        squares, vectors = np.linalg.eigh(inverse @ stiffness @ inverse.T)
        self.shapes = inverse.T @ vectors
        self.omega = np.sqrt(squares)
        coupled = self.shapes.T @ damping @ self.shapes
        self.damping = np.diag(coupled)
        if np.abs(coupled - np.diag(self.damping)).max() > 1e-9 * self.damping.max():
            raise ValueError("damping couples modes")
        self.load = self.shapes.T @ np.array(matrices["load"])


def segments(case, delays):
    """Pairs of the end of each segment between breakpoints of a_g, and a, b of a_g = a + b t for each delay in it."""
    values, step = np.array(case["acceleration"]), case["time_step"]
    own = step * np.arange(len(values))
    times = np.unique(np.concatenate([[0.0], *(own + delay for delay in delays)]))
    times = times[times < case["duration"] - 1e-9 * step]
    begins = times[np.concatenate([[True], np.diff(times) >= 1e-9 * step])]
    ends = np.append(begins[1:], case["duration"])
    columns = []
    for delay in delays:  # from within, as a_g may jump at the ends
        early, late = (begins + part * (ends - begins) for part in (0.25, 0.75))
        at_early, at_late = (np.interp(t - delay, own, values, left=0.0, right=0.0) for t in (early, late))
        slope = (at_late - at_early) / (late - early)
        columns += [at_early - slope * early, slope]
    return list(zip(ends.tolist(), np.array(columns).T.copy()))


class Model:
    """One case: its equations, and after `compile` the steppers that integrate it."""

    def __init__(self, case):
        length = case["largest_displacement"]
        buildings = [Building(of) for of in case["matrices"]]
        first = np.cumsum([0] + [len(of.omega) for of in buildings])
        self.scale = max(of.omega[0] * length / np.abs(of.shapes[:, 0]).max() for of in buildings)
        self.modes = int(first[-1])
        delays = sorted(set(case["delays"]))
        self.segments = segments(case, delays)
        self.inputs = 2 * len(delays)  # parameters of the ground motion; those of the contact points follow
        omega = np.concatenate([of.omega for of in buildings])
        x, v = (heyoka.make_vars(*(f"{name}{i}" for i in range(self.modes))) for name in "xv")
        terms = []  # of each mode's acceleration
        for b, of in enumerate(buildings):
            at = 2 * delays.index(case["delays"][b])
            ground = heyoka.par[at] + heyoka.par[at + 1] * heyoka.time
            for i, q in enumerate(range(first[b], first[b + 1])):
                terms.append([-of.omega[i] * x[q], -of.damping[i] * v[q], -of.load[i] / self.scale * ground])
        speeds = [(x[i], omega[i] * v[i]) for i in range(self.modes)]
        self.apart = speeds + [(v[i], heyoka.sum(terms[i])) for i in range(self.modes)]
        self.openings, self.turns, self.forces = [], [], []
        for c, point in enumerate(case["contacts"]):
            left, closed = point["left"], heyoka.par[self.inputs + c]
            sense = np.zeros(self.modes)
            sense[first[left]:first[left + 1]] = -buildings[left].shapes[point["left_floor"]]
            sense[first[left + 1]:first[left + 2]] = buildings[left + 1].shapes[point["right_floor"]]
            of = range(first[left], first[left + 2])
            parts = [sense[i] / omega[i] * x[i] for i in of]
            opening = heyoka.sum([heyoka.expression(point["width"] / self.scale), *parts])
            rate = heyoka.sum([sense[i] * v[i] for i in of])
            for i in of:
                terms[i].append(-sense[i] * (closed * (point["stiffness"] * opening)))
            # A gap of zero begins open, as in equations.h; an opening that turns counts while the point is closed.
            self.openings.append(opening + 1e-14 * length / self.scale)
            self.turns.append(closed * rate + (1.0 - closed))
            row = np.concatenate([-point["stiffness"] * self.scale * sense / omega, np.zeros(self.modes)])
            self.forces.append((row, -point["stiffness"] * point["width"]))
        self.touching = speeds + [(v[i], heyoka.sum(terms[i])) for i in range(self.modes)]

    def compile(self, tolerance):
        """Makes the steppers; returns the processor time it took."""
        heyoka.llvm_state.clear_memcache()
        began = time.process_time()
        points = range(len(self.openings))
        self.changes = [self.change(c) for c in points]
        self.notes = [self.note(c) for c in points]
        events = [heyoka.t_event(self.openings[c], callback=self.changes[c], cooldown=COOLDOWN) for c in points]
        turns = [heyoka.nt_event(self.turns[c], callback=self.notes[c], direction=heyoka.event_direction.positive)
                 for c in points]
        self.steppers = [heyoka.taylor_adaptive(equations, np.zeros(2 * self.modes), tol=tolerance, t_events=events,
                                                nt_events=of, pars=np.zeros(self.inputs + len(of)), fast_math=True)
                         for equations, of in ((self.apart, []), (self.touching, turns))]
        took = time.process_time() - began
        self.idle = heyoka.taylor_adaptive([(heyoka.make_vars("x"), heyoka.expression(0.0))], [0.0])
        self.states = [of.state for of in self.steppers]
        self.parameters = [of.pars for of in self.steppers]
        self.motion = [of[:self.inputs] for of in self.parameters]
        self.dense = self.steppers[1].d_output
        return took

    def change(self, c):
        """What the terminal event of contact point c does; whether its stepper goes on."""
        at = self.inputs + c

        def callback(_, direction):
            closed = self.parameters[1]
            if direction < 0 and closed[at] == 0.0:
                closed[at] = 1.0
                self.closed += 1
                self.impacts += 1
            elif direction > 0 and closed[at] != 0.0:
                closed[at] = 0.0
                self.closed -= 1
            return (self.closed > 0) == self.active
        return callback

    def note(self, c):
        """What the event does at which the opening of contact point c turns."""
        row, constant = self.forces[c]

        def callback(stepper, when, _):
            self.turned += 1
            stepper.update_d_output(when)
            self.peak = max(self.peak, float(row @ self.dense) + constant)
        return callback

    def restart(self):
        for i in range(2):
            self.states[i][:] = 0.0
            self.parameters[i][:] = 0.0
            self.steppers[i].time = 0.0
            self.steppers[i].reset_cooldowns()
        self.active, self.closed, self.peak = False, 0, 0.0
        self.impacts = self.turned = self.exchanged = self.steps = 0

    def exchange(self, row):
        """The other stepper goes on where this one stands, in the segment of these inputs."""
        old, new = int(self.active), int(not self.active)
        self.states[new][:] = self.states[old]
        self.motion[new][:] = row
        self.steppers[new].time = self.steppers[old].time
        self.active = not self.active
        self.exchanged += 1

    def go_through(self, steppers, over=1.0):
        """Integrates from segment to segment, each shortened to a part of its time `over`, 1 or 0."""
        go, motion, steps = [of.propagate_until for of in steppers], self.motion, 0
        for end, row in self.segments:
            motion[self.active][:] = row
            steps += go[self.active](over * end)[3]
            while (self.closed > 0) != self.active:
                self.exchange(row)
                steps += go[self.active](end)[3]
        self.steps = steps

    def run(self):
        """Integrates the case from rest to its end."""
        self.restart()
        self.go_through(self.steppers)

    def calls(self):
        """As many calls from and to Python as the last run had, with a stepper that has nothing to do."""
        impacts, turned, exchanged = self.impacts, self.turned, self.exchanged
        self.restart()
        self.go_through([self.idle, self.idle], over=0.0)
        for _ in range(exchanged):
            self.exchange(self.segments[0][1])
            self.steps += self.idle.propagate_until(0.0)[3]
        for _ in range(impacts):
            self.changes[0](self.idle, -1)
            self.changes[0](self.idle, 1)
        for _ in range(turned):
            self.notes[0](self.idle, 0.0, 1)


def timed(*works):
    """Processor times of several calls of each work, which take turns; each sorted [s]."""
    times = [[] for _ in works]
    while not times[0] or (sum(times[0]) < BUDGET or len(times[0]) < 5) and times[0][0] < CAP:
        for work, of in zip(works, times):
            began = time.process_time()
            work()
            of.append(time.process_time() - began)
    return [sorted(of) for of in times]


def search(path, out, details):
    """Tolerances from coarse to fine until two in a row are good enough, or a cap is reached."""
    case = json.loads(path.read_text())
    model, good = Model(case), 0
    for tolerance in TOLERANCES:
        compilation = model.compile(tolerance)
        model.run()
        peak, impacts, steps = model.peak, model.impacts, model.steps
        times, calls = timed(model.run, model.calls)
        error = abs(peak / case["matrices_peak_force"] - 1)
        print(f"{path.stem},heyoka,{tolerance:.1e},{times[0]:.6e},{times[len(times) // 2]:.6e},{len(times)},"
              f"{peak:.15g},{error:.3e},{impacts},{steps}", file=out, flush=True)
        last = compilation > COMPILATION_CAP
        print(f"{path.stem},{tolerance:.1e},{model.steppers[0].order},{len(model.segments)},{compilation:.6e},"
              f"{calls[0]:.6e},{'yes' if last else ''}", file=details, flush=True)
        good = good + 1 if error < WANTED else 0
        if good == 2 or times[0] > CAP:
            break
        if last:
            print(f"{path.stem}: heyoka at {tolerance:.1e}: {compilation:.0f} s to compile, no finer one is tried",
                  file=sys.stderr)
            break


def main():
    runs = pathlib.Path(sys.argv[1])
    heyoka.llvm_state.set_diskcache_enabled(False)  # the times of compilation are those of a first time
    with runs.open("a") as out, (runs.parent / "heyoka.csv").open("w") as details:
        print("case,setting,order,segments,compilation,calls,given_up", file=details)
        for path in map(pathlib.Path, sys.argv[2:]):
            print(f"bench: {path.stem}, heyoka", file=sys.stderr)
            search(path, out, details)


main()
