"""Reports on sweeps: statistics, figures, and a page with both (extra `analysis`).

`results` sorts rows by combinations, `statistics` and `figures` say and show what is in them,
`findings` puts that into tables, and `page` makes one HTML file of it all.
"""
