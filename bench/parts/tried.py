"""What was tried where a bar is missed: one paragraph for the bars whose names begin so."""

TRIED = {
    "bear, regions: growth":
        "*Growth of the cost of a quad.* The small mesh lies in the processor's cache, and what made it faster did little for "
        "the large one, which waits for memory. Tried: large pages behind large arrays, which helped most; asking early for "
        "what is laid, and touching less: codes counted in the order of the file, spokes noted in memory that is touched "
        "only where there are some, what is known of a face side by side. The ratio differs from run to run where the "
        "machine is shared.",
    "edited body:":
        "*Edited pairs.* The bars are ratios to the renumbered copy, which takes half the time it may (an eighth of "
        "bliss). Tried: a list of the faces near a rim, shared by all stages and kept up to date, so that none sweeps the "
        "whole mesh; lengths measured only where they are asked for; evidence counted at extraordinary vertices only; ghosts "
        "that give up where they cost more than can be gained; costs and target places kept; no branches on what nobody can "
        "guess, such as which corner of a face is the last; likelihoods learnt only where something is to be judged, and "
        "chance pairs told by one edge. What is left is mostly the fire itself, and after heavy edits minimum cuts.",
    "regions, plain: precision of unloop":
        "*Removed rows.* Which of two rows was removed is the toss of a coin where the row beside it is as regular "
        "([how often](#what-nobody-can-know)). Tried: lengths; calling ambiguous what they do not decide "
        "([why](design/009-ambiguity.md)); leaving out whole rows only, which found almost all that can be known.",
    "regions, connectivity: near":
        "*Removed and twisted rows without positions.* Which row of a run of parallel ones was removed nobody can know; "
        "[no method can be expected to reach the bar](#what-nobody-can-know), and beside it most of what is wrong is reported "
        "ambiguous. Tried: slides offered where corners disagree; parts beyond a ring turned as a whole, which settled "
        "twisted rings; leaving out whole rows only, which without lengths helps nothing.",
    "regions, connectivity: recall of heavy":
        "*Heavy edits without positions.* Half of the faces of a small model then have a corner that an edit changed. "
        "Tried: growth past such corners, cut back to what agrees beyond (ventures), one vote for slivers, islands "
        "judged by codes, restarts that ask for as much as there are places left, all of which helped; matching from the other "
        "mesh, and leaving out whole rows only, which did not; restarts near the partners of what is matched around, which found "
        "pieces of one model and laid a leg of another wrongly. What is still lost lies a row off, where on the small and on "
        "the evenly divided models the true match costs more than the one found; or it is pieces of some faces "
        "cut off on all sides, whose corners say less than the number of places where they might lie.",
    "regions, bent: recall of twist":
        "*Twisted rings of posed models.* The part beyond the ring lies as well a step round. Tried: slides; lengths compared as "
        "if the model were not stretched, which lets a part that slid as a whole explain itself; and parts beyond a ring turned "
        "as a whole, by lengths and tapers as they are, which helped most.",
    "invariance: same pairs, A and B swapped":
        "*Exchange.* What differs are heavy edits and the most edited real pairs, where minimum cuts from the other "
        "side end in another optimum of nearly the same cost. Tried: calling ambiguous what costs nearly the same, which "
        "helped most; beginning always at the smaller mesh, which makes all pairs of different sizes the same, but matches "
        "faces that are not the same where the earless bear grows into the one with ears; or at the larger one, which then no "
        "longer says that of a row that was cut in two either half may be the old one.",
    "carried UVs: exact, single edits":
        "*Carried UVs.* Where two rows run side by side from end to end, the mesh is the same whichever was taken out, so texture "
        "coordinates of the one that stayed are a toss of a coin: what is carried there is wrong as often as right. *Where told* counts "
        "the corners on which all such removals agree. Tried: faces that did not move are certain, and so is the row beside one "
        "that is gone as a whole, if the two part somewhere.",
    "vertices paired with the one opposite, edited":
        "*Mirrors of edited models.* Most of what is missed is part of a patch that was lifted, or in a rook, which is symmetric by "
        "rotation and not quite by mirrors; bent, it got bits of two of them. Tried: growth from the centre line, matching what "
        "is left over on one side with that on the other, believing the match where growth says the same; hops over new rows to what was lifted, and "
        "parts searched again for the one mirror, which helped the rook and laid limbs of a posed bear wrongly.",
    "batch: pairs/s":
        "*Many pairs.* Threads wait while match files and results are written to disk for good, and for memory that goes back to "
        "the system. Tried: all lookups left out in a new folder, slots of jobs at work without calls of the system.",
}


def tried(missed):
    """The paragraphs for these bars, each once."""
    return [text + "\n" for start, text in TRIED.items() if any(bar.what.startswith(start) for bar in missed)]
