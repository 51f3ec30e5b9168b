#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""rank_scaling: what water on many ranks costs: strong and weak scaling, and a model of the network's time.

usage: rank_scaling.py PROGRAM FOLDER   writes FOLDER/scaling.md and its image

PROGRAM is RankScaling, which counts what processes on this machine send and keeps the time it would take on
simulated networks. Its counts and network times do not depend on how busy the machine is; its work does.
"""

import json
import math
import pathlib
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Accuracy"))
from report import Report, plt  # noqa: E402
from tables import table  # noqa: E402

SIZE = (640, 360)
PROPS = 960  # of strong scaling
PROPS_A_RANK = 60  # of weak scaling
RANKS = (1, 2, 4, 8, 16)
CHECKED = (12, 600)  # ranks and props that the model has not seen
LATENCY_ONLY, BYTES_ONLY, ETHERNET, INFINIBAND = (1000, 0), (0, 100), (30, 1200), (2, 12000)
NETWORKS = (LATENCY_ONLY, BYTES_ONLY, ETHERNET, INFINIBAND)
NAMES = {ETHERNET: "10 Gbit/s, 30 us", INFINIBAND: "100 Gbit/s, 2 us"}
FAR = 1000  # ranks


def measure(program, ranks, props):
    command = [program, *map(str, (ranks, props, *SIZE)), *(f"{latency}:{speed}" for latency, speed in NETWORKS)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    row = json.loads(done.stdout.splitlines()[-1])
    print(row, flush=True)
    return row


def message_terms(ranks):
    """What the messages in a row are linear in: full levels of a binomial tree, and ranks."""
    return math.floor(math.log2(ranks)), ranks, 1


def byte_terms(ranks, props):
    """What the bytes in a row are linear in: levels of the tree, and props on each; ranks."""
    levels = math.ceil(math.log2(ranks))
    return levels, levels * props, ranks, 1


class Model:
    """Seconds of a frame = latency * messages in a row + bytes in a row / speed; both fitted by least squares."""

    def __init__(self, rows):
        def fit(terms, values):
            matrix = np.array(terms, float)
            scale = matrix.max(axis=0)
            return np.linalg.lstsq(matrix / scale, np.array(values), rcond=None)[0] / scale

        self.messages = fit([message_terms(row["ranks"]) for row in rows],
                            [row["network"][0] / (1e-6 * LATENCY_ONLY[0]) for row in rows])
        self.bytes = fit([byte_terms(row["ranks"], row["props"]) for row in rows],
                         [row["network"][1] * 1e6 * BYTES_ONLY[1] for row in rows])

    def messages_of(self, ranks):
        return float(self.messages @ np.array(message_terms(ranks), float))

    def seconds(self, network, ranks, props, pixels=1.0):
        """pixels: of the view, as a multiple of the measured one; the agreement does not grow with it."""
        in_a_row = self.bytes * np.array(byte_terms(ranks, props), float)
        in_a_row[[0, 3]] *= pixels
        return 1e-6 * network[0] * self.messages_of(ranks) + float(in_a_row.sum()) / (1e6 * network[1])


def plot(report, strong, weak, model):
    figure, (work, sent, time) = plt.subplots(1, 3, figsize=(11, 3.4))
    for rows, label in ((strong, f"{PROPS} props"), (weak, f"{PROPS_A_RANK} props a rank")):
        ranks = [row["ranks"] for row in rows]
        work.plot(ranks, [1e3 * row["work"] for row in rows], "o-", label=label)
        sent.plot(ranks[1:], [row["bytes_most"] / 1e6 for row in rows[1:]], "o-", label=label)
    work.plot(RANKS, [1e3 * strong[0]["work"] / ranks for ranks in RANKS], ":", color="0.5", label="ideal")
    for axis in (work, sent):
        axis.set_xscale("log", base=2)
        axis.set_xticks(RANKS, [str(ranks) for ranks in RANKS])
    work.set(yscale="log", xlabel="ranks", ylabel="CPU time of the busiest rank, ms")
    sent.set(xlabel="ranks", ylabel="MB sent by the busiest rank", ylim=(0, None))
    far = np.unique(np.geomspace(2, FAR, 60).astype(int))
    for number, network in enumerate((ETHERNET, INFINIBAND)):
        place = NETWORKS.index(network)
        color = f"C{number + 2}"
        time.plot(far, [1e3 * model.seconds(network, int(n), PROPS) for n in far], color=color, label=NAMES[network])
        time.plot(RANKS[1:], [1e3 * row["network"][place] for row in strong[1:]], "o", color=color)
    time.set(xscale="log", yscale="log", xlabel="ranks", ylabel="network's time of a frame, ms")
    for axis in (work, sent, time):
        axis.legend(fontsize=8)
    return report.save(figure, "ranks", "work, bytes and the network's time by the number of ranks")


def row_of(row):
    raw = 8e-6 * row["pixels"] * (row["ranks"] - 1)
    return (str(row["ranks"]), str(row["props"]), f"{1e3 * row['work']:.0f}", str(row["messages"]), str(row["messages_most"]),
            f"{row['bytes'] / 1e6:.2f}", f"{row['bytes_most'] / 1e6:.2f}", f"{raw:.2f}",
            *(f"{1e3 * row['network'][NETWORKS.index(network)]:.2f}" for network in (ETHERNET, INFINIBAND)))


def gpus_of(file):
    """What script/scaling --gpus has measured on a machine with several GPUs, as the text of the page."""
    if not file.exists():
        return "Not measured: no machine with several GPUs was available (`script/scaling --pack` says how)."
    measured = json.loads(file.read_text(encoding="utf-8"))
    runs = measured["runs"]
    first = runs[0]
    head = ("ranks", "GPUs", "ms, parts, dry", "ms, parts, with water", "ms, composited, dry",
            "ms, composited, with water", "MB", "messages", "% of pixels off, dry", "% of pixels off, with water")
    rows = [(str(run["ranks"]), str(len(set(run["gpus"]))),
             *(f"{run[name]:.2f}" for name in ("dry_part_ms", "wet_part_ms", "dry_ms", "wet_ms")),
             f"{run['bytes'] / 1e6:.2f}", f"{run['messages']:.0f}", f"{100 * run['off_dry']:.3f}",
             f"{100 * run['off_wet']:.3f}") for run in runs]
    return (f"Measured on one host with several GPUs ({measured['gpu']}): {first['triangles'] / 1e6:.0f} million "
            f"triangles in {first['props']} props, {first['size'][0]} x {first['size'][1]} pixels. Times are medians of "
            f"{first['frames']} frames, each with a new view, on the slowest rank. \"Dry\" means without water. \"% of "
            "pixels off\" is the share of pixels that differ from the picture of a single process. \"Parts\": each rank's "
            "picture shows only its own part of the scene, but the mirrored view is composited from all ranks. "
            "\"Composited\": `vtkCompositedSynchronizedRenderers` also composites the picture. Bytes and messages are those of the "
            "water. The ranks are processes that communicate over sockets. The first measurement is repeated at the end, to "
            "show the effect of the machine's other load.\n\n" + table(head, rows))


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    report = Report(folder, pathlib.Path(__file__).parent / "scaling.md.in")
    strong = [measure(program, ranks, PROPS) for ranks in RANKS]
    weak = [measure(program, ranks, PROPS_A_RANK * ranks) for ranks in RANKS[:-1]] + strong[-1:]
    model = Model([row for row in strong[1:] + weak[1:-1]])
    unseen = measure(program, *CHECKED)
    for network in (ETHERNET, INFINIBAND):
        found, expected = model.seconds(network, *CHECKED), unseen["network"][NETWORKS.index(network)]
        report.check_at_most(f"{NAMES[network]}, {CHECKED[0]} ranks, {CHECKED[1]} props: difference of model and simulation, %",
                             100 * abs(found / expected - 1), 15, 1)
    for row in strong[1:]:
        report.check_at_most(f"{row['ranks']} ranks: bytes of the frame / bytes of a picture (as above)",
                             row["bytes"] / (8 * row["pixels"] * (row["ranks"] - 1)), 1.1)
    report.check_at_most("16 ranks: work of the busiest rank / of one rank alone",
                         strong[-1]["work"] / strong[0]["work"], 0.25)
    head = ("ranks", "props", "work, ms", "messages", "messages of the busiest rank", "MB",
            "MB of the busiest rank", "MB of a picture",
            *(f"ms, {NAMES[network]}" for network in (ETHERNET, INFINIBAND)))
    report.add("Figures of a frame", "$rows\n\n$plot", rows=table(head, [row_of(row) for row in strong + weak[:-1]]),
               plot=plot(report, strong, weak, model))
    hd = 1920 * 1080 / (SIZE[0] * SIZE[1])
    predicted = [(NAMES[network], f"{FAR * scale if scale > 1 else PROPS}", size,
                  f"{1e3 * model.seconds(network, FAR, FAR * scale if scale > 1 else PROPS, pixels):.1f}")
                 for network in (ETHERNET, INFINIBAND) for scale in (1, PROPS_A_RANK)
                 for size, pixels in (("640 x 360", 1.0), ("1920 x 1080", hd))]
    report.write(gpus=gpus_of(folder / "scaling-gpus.json"), predicted=table(("network", "props", "picture", "ms per frame"), predicted),
                 far_messages=f"{model.messages_of(FAR):.0f}",
                 far_ranks=FAR, size=f"{SIZE[0]} x {SIZE[1]}")
    sys.exit(1 if report.has_failed() else 0)


if __name__ == "__main__":
    main()
