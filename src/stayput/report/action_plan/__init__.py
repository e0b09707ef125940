"""A plan to buy and do as a card to print, and as data."""
