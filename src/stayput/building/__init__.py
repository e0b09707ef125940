"""What stands between the ground and the furniture: a building, and the motion of its floors."""
