// Keeps the page for use without a network. The stamp changes with what is kept.
const OURS = `effigy ${registration.scope} `, KEPT = `${OURS}@STAMP@`;
const FILES = ["./", @FILES@];

self.addEventListener("install", (event) => {
  // Of one version all: what the browser kept on its own may be older.
  const files = FILES.map((file) => new Request(file, { cache: "reload" }));
  event.waitUntil(caches.open(KEPT).then((cache) => cache.addAll(files)).then(() => self.skipWaiting()));
});
self.addEventListener("activate", (event) => {
  // Other folders of this host may hold an Effigy of their own.
  const old = (name) => name.startsWith(OURS) && name !== KEPT;
  event.waitUntil(caches.keys().then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name)))).then(() => self.clients.claim()));
});
self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) return;
  event.respondWith(caches.open(KEPT).then((cache) => cache.match(event.request, { ignoreSearch: true })).then((kept) => kept ?? fetch(event.request)));
});
