"""Run a program and say what it took. usage: measured_run.py FIGURES PROGRAM ARGUMENT...; writes JSON to FIGURES.

A program of its own, and a small one: Linux counts the memory of whoever starts a process to that process's peak.
"""
import json
import os
import sys
import time

began = time.perf_counter()
process = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
_, status, usage = os.wait4(process, 0)
figures = {"milliseconds": 1e3 * (time.perf_counter() - began), "processor_seconds": usage.ru_utime + usage.ru_stime,
           "peak": 1024 * usage.ru_maxrss, "status": os.waitstatus_to_exitcode(status)}
with open(sys.argv[1], "w", encoding="utf-8") as file:
    json.dump(figures, file)
