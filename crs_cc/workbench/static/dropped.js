/** Files that are dropped on the page: a recording, to compare the run with. */

/** @param {any} page */
export function listenToFiles(page) {
  const isFile = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files") && page.takeFile;
  addEventListener("dragover", (event) => isFile(event) && event.preventDefault());
  addEventListener("drop", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    const [file] = event.dataTransfer?.files ?? [];
    if (file) page.takeFile(file);
  });
}
