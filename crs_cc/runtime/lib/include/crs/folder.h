/* Listing folders, for the library itself. */
#ifndef CRS_FOLDER_H
#define CRS_FOLDER_H

#include <dirent.h>

DIR *__crs_open_folder(const char *name);
struct dirent *__crs_read_folder(DIR *folder);
void __crs_close_folder(DIR *folder);

/* fnmatch under a name of ours. */
int __crs_match_name(const char *pattern, const char *text, int flags);

#endif
