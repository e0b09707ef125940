"""What shakes: records, their readers, and synthetic motions."""
