"""What was tried where a bar is missed: one paragraph for the bars whose names begin so."""

TRIED = {
    "bear, regions: growth":
        "*Growth of the cost of a quad.* The small mesh lies in the processor's cache, and what made it faster did little for "
        "the large one, which waits for memory. Tried: prefetching while equal parts are laid. The ratio differs from run to "
        "run where the machine is shared.",
    "edited body:":
        "*Edited pairs.* The bars are ratios to the renumbered copy, which takes half the time it may (an eighth of "
        "bliss). Tried: a list of the faces near a rim, shared by all stages and kept up to date, so that none sweeps the "
        "whole mesh; lengths measured only where they are asked for; evidence counted at extraordinary vertices only; ghosts "
        "that give up where they cost more than can be gained; costs and target places kept. What is left is mostly the "
        "fire itself, and after heavy edits minimum cuts.",
    "regions, plain: precision of unloop":
        "*Removed rows.* Which of two rows was removed is a guess where edge lengths do not tell; what lacks precision "
        "are faces of the removed row, matched in place of their neighbours. Tried: lengths, and calling ambiguous what "
        "they do not decide ([why](design/009-ambiguity.md)); here they seem to decide, and wrongly.",
    "regions, connectivity: near":
        "*Removed and twisted rows without positions.* Of a removed row one of two is right by the toss of a coin; a "
        "ring turned against the rest looks the same until an extraordinary vertex disagrees, and beyond a symmetric "
        "part none does. Tried: slides offered where corners disagree, which helped twisted rings much and "
        "removed rows not at all. Beside removed rows most of what is wrong is reported ambiguous, beyond twisted "
        "rings hardly any.",
    "regions, connectivity: recall of heavy":
        "*Heavy edits without positions.* Half of the faces of a small model then have a corner that an edit changed. "
        "Tried: growth past such corners, cut back to what agrees beyond (ventures), one vote for slivers, islands "
        "judged by codes, restarts that ask for as much as there are places left; all of them helped. What is still lost "
        "was never grown, or lies a row off.",
    "regions, bent: recall of twist":
        "*Twisted rings of posed models.* As without positions: the part beyond the ring lies as well a step round, and "
        "the lengths of a posed model hardly say otherwise. Tried: slides, and lengths compared as if the model were not "
        "stretched, which helps all else on sculpted models, but here lets a part that slid as a whole explain itself.",
    "invariance: same pairs, A and B swapped":
        "*Exchange.* What differs are heavy edits and the most edited real pairs, where minimum cuts from the other "
        "side end in another optimum of nearly the same cost. Tried: calling ambiguous what costs nearly the same, which "
        "helped most.",
    "carried UVs: exact, single edits":
        "*Carried UVs.* Of a rotation-symmetric mesh that lost a row, nothing says which row was lost: taking out either of two "
        "leaves the very same mesh, so the faces beside it are doubtful, and what is doubtful is not carried unless asked for; "
        "*where told* counts the corners on which all such removals agree. Tried: faces that did not move are certain, and so is "
        "the row beside one that is gone as a whole, if the two part somewhere; with `--allow-ambiguous` all are carried, and "
        "those of the toss are as often wrong as right.",
    "vertices paired with the one opposite, edited":
        "*Mirrors of edited models.* Most of what is missed is part of a patch that was lifted, or in a rook, which is symmetric by "
        "rotation and not quite by mirrors; bent, it got bits of two of them. Tried: growth from the centre line, matching what "
        "is left over on one side with that on the other, believing the match where growth says the same.",
    "batch: pairs/s":
        "*Many pairs.* Threads wait while match files and results are written to disk for good, and for memory that goes back to "
        "the system. Tried: all lookups left out in a new folder, slots of jobs at work without calls of the system.",
}


def tried(missed):
    """The paragraphs for these bars, each once."""
    return [text + "\n" for start, text in TRIED.items() if any(bar.what.startswith(start) for bar in missed)]
