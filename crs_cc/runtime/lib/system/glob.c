/* Names of files by patterns (POSIX glob). */
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>

#include <crs/descriptor.h>
#include <crs/folder.h>

#define LONGEST 256

struct search {
    glob_t *found;
    int flags;
    int (*report)(const char *name, int error);
    int failed;
};

/* Appends a name; the list ends with a null pointer. */
static void add(struct search *search, const char *name, int is_folder)
{
    glob_t *found = search->found;
    size_t first = found->gl_offs, size = strlen(name);
    char **larger = realloc(found->gl_pathv, (first + found->gl_pathc + 2) * sizeof *larger);
    char *copy = malloc(size + 2);

    if (larger != NULL)
        found->gl_pathv = larger;
    if (larger == NULL || copy == NULL) {
        free(copy);
        search->failed = GLOB_NOSPACE;
        return;
    }
    strcpy(copy, name);
    if (is_folder && search->flags & GLOB_MARK && size > 0 && name[size - 1] != '/')
        strcpy(copy + size, "/");
    while (found->gl_pathc == 0 && first > 0)
        larger[--first] = NULL;
    first = found->gl_offs;
    larger[first + found->gl_pathc++] = copy;
    larger[first + found->gl_pathc] = NULL;
}

static int is_folder(const char *name)
{
    DIR *folder = __crs_open_folder(name);

    __crs_close_folder(folder);
    return folder != NULL;
}

static int is_file(const char *name)
{
    int descriptor = __crs_open(name, O_RDONLY);

    if (descriptor >= 0)
        __crs_close(descriptor);
    return descriptor >= 0;
}

static void search_in(struct search *search, char *name, size_t size, const char *pattern);

/* Goes on with an entry whose name has been appended to `name`. */
static void go_on(struct search *search, char *name, size_t size, const char *rest)
{
    if (*rest == 0) {
        if (is_file(name) || is_folder(name))
            add(search, name, is_folder(name));
        return;
    }
    while (*rest == '/' && size + 1 < LONGEST)
        name[size++] = *rest++;
    name[size] = 0;
    if (*rest == 0) {
        if (is_folder(name))
            add(search, name, 1);
    } else {
        search_in(search, name, size, rest);
    }
}

/* Searches the folder whose name is in `name` for the first part of a pattern. */
static void search_in(struct search *search, char *name, size_t size, const char *pattern)
{
    size_t length = strcspn(pattern, "/");
    int flags = FNM_PERIOD | (search->flags & GLOB_NOESCAPE ? FNM_NOESCAPE : 0);
    char part[LONGEST];
    struct dirent *entry;
    DIR *folder;

    if (length >= LONGEST || size + length >= LONGEST)
        return;
    memcpy(part, pattern, length);
    part[length] = 0;
    if (strpbrk(part, "*?[\\") == NULL) {
        strcpy(name + size, part);
        go_on(search, name, size + length, pattern + length);
        name[size] = 0;
        return;
    }
    folder = __crs_open_folder(size > 0 ? name : ".");
    if (folder == NULL) {
        if (errno != ENOENT && errno != ENOTDIR &&
            ((search->report != NULL && search->report(name, errno)) || search->flags & GLOB_ERR))
            search->failed = GLOB_ABORTED;
        return;
    }
    while (!search->failed && (entry = __crs_read_folder(folder)) != NULL) {
        if (__crs_match_name(part, entry->d_name, flags) != 0 ||
            size + strlen(entry->d_name) >= LONGEST)
            continue;
        strcpy(name + size, entry->d_name);
        go_on(search, name, strlen(name), pattern + length);
        name[size] = 0;
    }
    __crs_close_folder(folder);
}

static int by_name(const void *left, const void *right)
{
    return strcmp(*(char *const *)left, *(char *const *)right);
}

int glob(const char *pattern, int flags, int (*report)(const char *name, int error), glob_t *found)
{
    struct search search = {found, flags, report, 0};
    char name[LONGEST] = "";
    size_t first = flags & GLOB_DOOFFS ? found->gl_offs : 0, before;

    found->gl_offs = first;
    if (!(flags & GLOB_APPEND)) {
        found->gl_pathc = 0;
        found->gl_pathv = NULL;
    }
    before = found->gl_pathc;
    go_on(&search, name, 0, pattern);
    if (search.failed)
        return search.failed;
    if (found->gl_pathc == before) {
        if (!(flags & GLOB_NOCHECK))
            return GLOB_NOMATCH;
        add(&search, pattern, 0);
    }
    if (!(flags & GLOB_NOSORT))
        qsort(found->gl_pathv + first + before, found->gl_pathc - before, sizeof(char *), by_name);
    return search.failed;
}

void globfree(glob_t *found)
{
    size_t i;

    for (i = 0; i < found->gl_pathc; i++)
        free(found->gl_pathv[found->gl_offs + i]);
    free(found->gl_pathv);
    found->gl_pathv = NULL;
    found->gl_pathc = 0;
}
