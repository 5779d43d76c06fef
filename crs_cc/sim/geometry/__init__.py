"""Where things are, what shape they have, and what beams meet."""
