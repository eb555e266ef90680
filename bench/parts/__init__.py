"""The parts of bench/run.py: each measures one thing (`measure`), tells it (`page`), and holds it against a bar (`bars`)."""
