"""Output: texts, plots, animations and reports of runs, motions and verdicts."""
