#!/usr/bin/env python3
"""orders.py SEED ORDERS EVENTS: a script for the host with random orders of what a system may do to an app, always such that are allowed. All are
played to one activity, which is in the background for good after each; the last ends with its destruction."""
import random
import sys


def script(seed, orders, events):
    lines = [f"# seed {seed}", "vsync 0", "create"]
    for number in range(orders):
        lines += [f"# order {number}"] + order(random.Random(f"{seed} {number}"), events)
    return "\n".join(lines + ["destroy"]) + "\n"


def order(pick, events):
    size = [pick.randrange(60, 400), pick.randrange(60, 400)]
    lines = ["turn 0"]
    started = resumed = window = queue = False
    turn = 0
    for _ in range(events):
        can = ["lowmemory", "config"]
        if not started:
            can += ["start"] * 4
        elif not resumed:
            can += ["resume"] * 4 + ["stop"] * (not window)
        else:
            can += ["pause"]
        if started and not window:
            can += ["window"] * 3
        if window:
            can += ["nowindow"] + ["resize", "turn", "focus"]
        if started and not queue:
            can += ["queue"] * 2
        if queue:
            can += ["touch"] * 3 + ["noqueue"]
        if resumed and window:
            can += ["frames"] * 4
        what = pick.choice(can)
        if what == "start":
            started = True
        elif what == "stop":
            started = False
        elif what == "resume":
            resumed = True
        elif what == "pause":
            resumed = False
        elif what == "queue":
            queue = True
        elif what == "noqueue":
            queue = False
        elif what == "nowindow":
            window = False
        elif what in ("window", "resize"):
            window = True
            size = [pick.randrange(1, 400), pick.randrange(1, 400)] if pick.random() < 0.5 else size[::-1]
            what += " {} {}".format(*size)
        elif what == "turn":
            turn = pick.randrange(4)
            what = f"turn {turn}"
        elif what == "config":
            what = f"config {pick.choice([160, 320, 420, 640])}"
        elif what == "focus":
            what = f"focus {pick.randrange(2)}"
        elif what == "frames":
            # A touch may have paused the clip, so there may be none: time for a few.
            what = f"sleep {pick.randrange(5, 80)}"
        elif what == "touch":
            finger = pick.randrange(3)
            what = f"touch2 {finger} {pick.choice(['down', 'move', 'up'])} {pick.randrange(400)} {pick.randrange(400)}"
        lines.append(what)
    return lines + ["focus 0"] * window + ["pause"] * resumed + ["nowindow"] * window + ["noqueue"] * queue + ["stop"] * started


if __name__ == "__main__":
    sys.stdout.write(script(*map(int, sys.argv[1:])))
