"""Charts that a reader keeps: as SVG or PDF with a caption, or as the numbers behind them."""
