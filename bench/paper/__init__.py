"""The parts of docs/paper/: each measures something the paper claims, and writes its page.

A part has a TITLE, an INTRODUCTION, `measure(options)`, which returns raw figures, and `page(raw)`, which makes lines of
Markdown of them; `bars(raw)`, if it has any, is what is asked of them.
"""
from paper import exact, figures, future_work, gap, guarantee, hardness, isomorphism, tables

# In the order of the pages.
PARTS = {"figures": figures, "tables": tables, "hardness": hardness, "exact": exact, "gap": gap, "guarantee": guarantee,
         "isomorphism": isomorphism, "future_work": future_work}
