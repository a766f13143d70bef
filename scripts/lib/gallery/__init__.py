"""Pictures of every kind of light beside their reference, as docs/gallery.md."""
