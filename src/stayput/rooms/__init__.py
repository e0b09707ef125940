"""A room: where its furniture comes to lie in an earthquake, who is hit, which door stays shut."""
