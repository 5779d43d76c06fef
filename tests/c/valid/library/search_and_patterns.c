/* Bessel functions, drand48_r, trees, hash tables, patterns, dates, queues. */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <time.h>
#include <search.h>
#include <fnmatch.h>
#include <sched.h>
#include <grp.h>
#include <sys/queue.h>
static int cmp(const void *a, const void *b) {
    return strcmp(a, b);
}
static void act(const void *n, VISIT v, int d) {
    if (v==postorder||v==leaf) printf("%s@%d ", *(char **)n, d==0);
}
struct item {
    int v;
    TAILQ_ENTRY(item) q;
    LIST_ENTRY(item) l;
    STAILQ_ENTRY(item) s;
    SLIST_ENTRY(item) sl;
};
TAILQ_HEAD(tq, item);
LIST_HEAD(lh, item);
STAILQ_HEAD(sq, item);
SLIST_HEAD(slh, item);
static void f(const char *p, const char *t, int flags) {
    printf("%d", fnmatch(p, t, flags));
}
static void d(const char *text, const char *format) {
    struct tm t;
    memset(&t, 0, sizeof t);
    char *e=strptime(text, format, &t);
    char b[80];
    if(!e) {
        puts("null");
        return;
    }
    strftime(b, 80, "%F %T %a %j", &t);
    printf("%s [%s]\n", b, e);
}
int main(void) {
    static const double xs[]={0.1, 1, 2.404, 5, 10, 24.9, 25.1, 50, 1000};
    unsigned i;
    int n;
    for(i=0;i<9;i++) printf("%.10g %.10g %.10g %.10g\n", j0(xs[i]), j1(xs[i]), y0(xs[i]),
            y1(xs[i]));
    for(i=0;i<9;i++) for(n=-2;n<40;n+=7) printf("%.9g %.9g ", jn(n, xs[i]), yn(n, xs[i]));
    puts("");
    struct drand48_data r;
    double v;
    long l;
    memset(&r, 0, sizeof r);
    srand48_r(42, &r);
    drand48_r(&r, &v);
    printf("%.12g ", v);
    lrand48_r(&r, &l);
    printf("%ld ", l);
    mrand48_r(&r, &l);
    printf("%ld\n", l);
    const char *w[]={"m", "c", "x", "a", "d", "z", "n"};
    void *root=NULL;
    for(i=0;i<7;i++) tsearch(w[i], &root, cmp);
    printf("%d %d\n", tfind("x", &root, cmp)!=NULL, tfind("q", &root, cmp)!=NULL);
    tdelete("c", &root, cmp);
    tdelete("m", &root, cmp);
    for(i=0;i<7;i++) printf("%d", tfind(w[i], &root, cmp)!=NULL);
    puts("");
    hcreate(10);
    for(i=0;i<7;i++) {
        ENTRY e;
        e.key=(char*)w[i];
        e.data=(char*)w[6-i];
        hsearch(e, ENTER);
    }
    ENTRY q={"d", NULL};
    printf("%s ", (char*)hsearch(q, FIND)->data);
    q.key="no";
    printf("%d\n", hsearch(q, FIND)==NULL);
    hdestroy();
    f("*.c", "a.c", 0);
    f("*.c", "a.h", 0);
    f("[a-c]?[!x]*", "bzy", 0);
    f("*", "a/b", FNM_PATHNAME);
    f("*/b", "a/b", FNM_PATHNAME);
    f("*", ".x", FNM_PERIOD);
    f("\\*", "*", 0);
    f("\\*", "*", FNM_NOESCAPE);
    f("A*", "abc", FNM_CASEFOLD);
    f("a*b*c", "aXbYbZc", 0);
    f("[[:digit:]]*", "7up", 0);
    f("a", "a/b", FNM_LEADING_DIR);
    f("[", "[", 0);
    f("", "", 0);
    f("*?", "", 0);
    f("a[]b]c", "a]c", 0);
    puts("");
    d("2001-02-03 04:05:06", "%Y-%m-%d %H:%M:%S");
    d("Sat Feb  3 2001 11:05 PM x", "%a %b %e %Y %I:%M %p");
    d("070/99", "%j/%y");
    d("12/25/68", "%D");
    d("13:61", "%R");
    d("  March 7, 1999", "%B %d, %Y");
    d("1000000000", "%s");
    d("20 05", "%C %y");
    struct item it[4];
    struct tq tq=TAILQ_HEAD_INITIALIZER(tq);
    struct lh lh;
    struct sq sq;
    struct slh slh;
    struct item *e;
    LIST_INIT(&lh);
    STAILQ_INIT(&sq);
    SLIST_INIT(&slh);
    for(i=0;i<4;i++) {
        it[i].v=i;
        if(i%2) TAILQ_INSERT_TAIL(&tq, &it[i], q);
        else TAILQ_INSERT_HEAD(&tq, &it[i], q);
        LIST_INSERT_HEAD(&lh, &it[i], l);
        STAILQ_INSERT_TAIL(&sq, &it[i], s);
        SLIST_INSERT_HEAD(&slh, &it[i], sl);
    }
    TAILQ_REMOVE(&tq, &it[0], q);
    LIST_REMOVE(&it[3], l);
    STAILQ_REMOVE(&sq, &it[3], item, s);
    SLIST_REMOVE(&slh, &it[1], item, sl);
    TAILQ_FOREACH(e, &tq, q) printf("%d", e->v);
    TAILQ_FOREACH_REVERSE(e, &tq, tq, q) printf("%d", e->v);
    LIST_FOREACH(e, &lh, l) printf("%d", e->v);
    STAILQ_FOREACH(e, &sq, s) printf("%d", e->v);
    SLIST_FOREACH(e, &slh, sl) printf("%d", e->v);
    puts("");
    printf("%d %d\n", sched_yield(), sched_get_priority_max(SCHED_FIFO));
    return 0;
}

