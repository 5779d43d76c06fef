/*
   A program in the style of the time: everything global, tentative definitions,
   macros with arguments, register pointers, printf without a prototype.
*/
#include <stdio.h>

# define MAXLINE   80
# define MAXWORDS  20
# define isletter(c)  (((c) >= 'a' && (c) <= 'z') || ((c) >= 'A' && (c) <= 'Z'))
# define lower(c)     ((c) >= 'A' && (c) <= 'Z' ? (c) + ('a' - 'A') : (c))
# define FOREVER for (;;)

char line[MAXLINE];
struct tnode {
    char *word;
    int count;
    struct tnode *left, *right;
} nodes[MAXWORDS], *root;
struct tnode *root;
int used;
char words[200], *free_space = words;

char *text = "The robot saw the wall and THE wall saw the robot; the end.";

struct tnode *
tree(p, w)
    struct tnode *p;
    char *w;
{
    int cond;

    if (p == NULL) {
        p = &nodes[used++];
        p->word = free_space;
        while (*free_space++ = *w++)
            ;
        p->count = 1;
    } else if ((cond = compare(w, p->word)) == 0)
        p->count++;
    else if (cond < 0)
        p->left = tree(p->left, w);
    else
        p->right = tree(p->right, w);
    return (p);
}

compare(s, t)
    register char *s, *t;
{
    for ( ; *s == *t; s++, t++)
        if (*s == '\0')
            return (0);
    return (*s - *t);
}

treeprint(p)
    struct tnode *p;
{
    if (p) {
        treeprint(p->left);
        printf("%4d %s\n", p->count, p->word);
        treeprint(p->right);
    }
}

getword(w, s)
    register char *w;
    char **s;
{
    register c;

    while ((c = *(*s)++) && !isletter(c))
        ;
    if (c == 0)
        return (0);
    do
        *w++ = lower(c);
    while (c = *(*s)++, isletter(c));
    (*s)--;
    *w = '\0';
    return (1);
}

main()
{
    char *s = text;

    FOREVER {
        if (!getword(line, &s))
            break;
        root = tree(root, line);
    }
    treeprint(root);
    exit(0);
}
