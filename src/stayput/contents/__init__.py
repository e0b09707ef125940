"""What is inside furniture: what slides, topples and comes out of its shelves as the piece itself moves."""
