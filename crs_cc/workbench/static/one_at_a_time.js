/**
 * Return a function that asks something of the server, one call at a time: calls meanwhile make it
 * call it once more, since what is under way may be about another robot or an earlier time.
 * @param {() => Promise<void>} refresh
 */
export function oneAtATime(refresh) {
  let isAsking = false;
  let isStale = false;
  return async function run() {
    isStale = isAsking;
    if (isAsking) return;
    isAsking = true;
    try {
      await refresh();
    } finally {
      isAsking = false;
    }
    if (isStale) run();
  };
}
