"""Pictures of runs from above, as SVG: `picture` draws the world, paths and contacts."""
