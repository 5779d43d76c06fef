/* Regular expressions: the parsed form. */
#ifndef CRS_REGULAR_H
#define CRS_REGULAR_H

#include <regex.h>

enum kind { EMPTY, ANY, CHARACTER, SET, START, END, GROUP, BACK, REPEAT, SEQUENCE, CHOICE };

#define UNLIMITED 0x7fff

/* A node; left and right are indices of nodes. */
struct node {
    enum kind kind;
    int left, right;         /* of REPEAT and GROUP the left one only */
    int value;               /* a character, the number of a group, or of a set */
    int least, most;         /* of REPEAT */
};

struct __crs_regex {
    int flags, root, nodes, room, sets;
    struct node *node;
    unsigned char (*set)[32];   /* a bit for each character */
};

#endif
