/* Flexible array members with initial values, which determine their size. */
#include <stdio.h>
#include <string.h>
struct f {
    int n;
    short v[];
};
static struct f a = {3, {1,2,3}};
struct f b = {.n = 2, .v = {[1] = 7}};
static struct f c = {0};
struct g {
    int n;
    char text[];
} d = {5, "hello"};
struct z {
    int n;
    int v[0];
};
struct z zz = {1};
struct p {
    int n;
    struct q {
        int a;
        char *s;
    } v[];
} e = {2, {{1, "one"}, {2, "two"}}};
static struct f *list[] = {&a, &b, &c};
int main(void){
    struct z *p;
    int i,j;
    static struct f loc = {1, {42}};
    for (i=0;i<3;i++){
        for(j=0;j<list[i]->n;j++) printf("%d ", list[i]->v[j]);
        printf("| ");
    }
    printf("%s %d %d %s %d\n", d.text, (int)sizeof a, (int)sizeof d, e.v[1].s, loc.v[0]);
    printf("%d %d\n", (int)sizeof(struct z), (int)sizeof zz.v);
    return 0;
}

