"""The pictures of docs/results.md, from the raw figures; the same bytes every time."""
import statistics

from parts import quality, regions, speed

SPEED_LINES = {"regions": ("C0", "-", "regions, renumbered"), "regions-in-file-order": ("C0", "--", "regions, file order"),
               "lazy-greedy": ("C1", "-", "lazy-greedy, renumbered"),
               "lazy-greedy-in-file-order": ("C1", "--", "lazy-greedy, file order"), "greedy": ("C2", "-", "greedy, renumbered"),
               "build": ("0.6", ":", "build one mesh")}


def pyplot():
    """Debian's python3-matplotlib, set so that it writes no dates and no random names."""
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot
    matplotlib.rcParams.update({"svg.hashsalt": "quadmatch", "font.size": 9, "axes.spines.top": False,
                                "axes.spines.right": False, "axes.grid": True, "grid.alpha": 0.3})
    return matplotlib.pyplot


def save(options, figure, name):
    folder = options.docs / "results"
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / name, metadata={"Date": None}, bbox_inches="tight")
    pyplot().close(figure)


def draw_speed(options):
    subjects = speed.subjects_kept(options)
    if not subjects:
        return
    figure, panels = pyplot().subplots(1, len(subjects), figsize=(4.5 * len(subjects), 3.4), sharey=True, squeeze=False)
    for panel, (name, subject) in zip(panels[0], subjects.items()):
        for what, (colour, style, label) in SPEED_LINES.items():
            if what in subject.measured():
                panel.plot(subject.sizes, [subject.per_quad(what, size) for size in subject.sizes], style, color=colour,
                           marker=".", label=label)
        panel.set(title=name, xlabel="quads", xscale="log")
    panels[0][0].set_ylabel("nanoseconds per quad")
    panels[0][0].set_ylim(bottom=0)  # of all, once all have their lines
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, frameon=False, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1))
    save(options, figure, "speed.svg")


def draw_recall(options):
    """Mean recall for each edit: a bar for each algorithm and condition."""
    runs = dict(quality.rows_kept(options))
    runs |= {f"regions, {name}": rows for name, rows in regions.runs_kept(options).items()}
    if not runs:
        return
    edits = list(quality.PROTOTYPE_RECALL)
    figure, panel = pyplot().subplots(figsize=(9, 3.6))
    for index, (name, rows) in enumerate(runs.items()):
        means = [[row["recall"] for row in rows if row["edit"] == edit and "recall" in row] for edit in edits]
        places = [place + 0.8 * ((index + 0.5) / len(runs) - 0.5) for place in range(len(edits))]
        panel.bar(places, [statistics.mean(values) if values else 0 for values in means], width=0.8 / len(runs),
                  label=name, color="0.8" if name == "greedy" else "0.6" if name == "lazy-greedy" else f"C{index - 2}")
    panel.set(ylabel="mean recall", ylim=(0, 1), xlim=(-0.6, len(edits) - 0.4))
    panel.set_xticks(range(len(edits)), edits, rotation=30)
    panel.legend(frameon=False, ncols=4, loc="lower center", bbox_to_anchor=(0.5, 1))
    save(options, figure, "recall.svg")


def draw_all(options):
    draw_speed(options)
    draw_recall(options)
