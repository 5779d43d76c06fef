/* Compound literals at file scope, and in initialisers, arguments, loops and conditions. */
#include <stdio.h>
struct p {
    int x, y;
};
struct line {
    struct p *a, b;
    const char **names;
};
static struct p *sp = &(struct p){1, 2};
static int *arr = (int[]){1,2,3};
struct line gl = { &(struct p){3,4}, {5,6}, (const char *[]){"a", "b", 0} };
static const char *s = (char[]){"text"};
static int n = sizeof (int[]){1,2,3,4};
static struct p gp = (struct p){7,8};
static struct p table[] = { (struct p){1,1}, {2,2}, [3] = (struct p){.y = 9} };
static int sum(struct p q, const int *v, int n){
    int r = q.x + q.y;
    while (n--) r += *v++;
    return r;
}
int *g(int n){
    static int *k = 0;
    return n ? (int[2]){
        n, n+1
    }
    + 1 : k;
}
int main(void){
    int i;
    struct p *q[3];
    for (i = 0; i < 3; i++) q[i] = &(struct p){
        i, i*i
    };
    printf("%d %d %d %d %s %d %d\n", sp->y, arr[2], gl.a->y, gl.b.x, gl.names[1], n, gp.y);
    printf("%d %d %d\n", table[0].x, table[3].y, (int)(sizeof table/sizeof*table));
    printf("%d\n", sum((struct p){
        1,2
    }
    , (int[]){
        3,4,5
    }
    , 3));
    (struct p){
        1,2
    }
    .x;
    printf("%d %d\n", (struct p){
        .y=4
    }
    .y, q[0]->x + (int){
        3
    }
    );
    int *pi = &(int){5};
    ++*pi;
    printf("%d %s\n", *pi, s);
    const struct p *c = &(const struct p){1,2};
    printf("%d %c\n", c->y, "abc"[1] + (char){
        1
    }
    );
    for (int k = 0; k < 3; k++) {
        int *z = (int[3]){k};
        z[1]++;
        printf("%d%d ", z[0], z[1]);
    }
    printf("%d\n", (*&(int){
        9
    }
    )++ );
    return 0;
}

