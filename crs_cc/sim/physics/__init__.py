"""Rigid-body physics: motion of bodies with contacts and friction. Only this folder uses pymunk."""
