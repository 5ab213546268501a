#!/usr/bin/env python3
"""orders.py SEED EVENTS: a script for the host with a random order of what a system may do to an app, always one that is allowed."""
import random
import sys


def script(seed, events):
    pick = random.Random(seed)
    size = [pick.randrange(60, 400), pick.randrange(60, 400)]
    lines = [f"# seed {seed}", "vsync 0", "create"]
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
            what = f"sleep {pick.randrange(10, 200)}"
        elif what == "touch":
            finger = pick.randrange(3)
            what = f"touch2 {finger} {pick.choice(['down', 'move', 'up'])} {pick.randrange(400)} {pick.randrange(400)}"
        lines.append(what)
    lines += ["focus 0"] * window + ["pause"] * resumed + ["nowindow"] * window + ["noqueue"] * queue + ["stop"] * started + ["destroy"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write(script(int(sys.argv[1]), int(sys.argv[2])))
