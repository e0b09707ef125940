"""What is shown: words, plots and animations of a run."""
