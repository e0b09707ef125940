"""The app: a REST API over the package, and a page that uses nothing else; see `stayput.app.server`."""
