"""The parts of docs/paper/: each measures something the paper claims, and writes its page.

A part has a TITLE, an INTRODUCTION, `measure(options)`, which returns raw figures, and `page(raw)`, which makes lines of
Markdown of them.
"""
from paper import figures, future_work, gap, guarantee, hardness, tables

# In the order of the pages.
PARTS = {"figures": figures, "tables": tables, "gap": gap, "hardness": hardness, "guarantee": guarantee,
         "future_work": future_work}
