/* Members of anonymous structs and unions, with and without designators. */
#include <stdio.h>
struct v {
    union {
        struct {
            float x, y, z;
        };
        float e[3];
    };
    _Static_assert(sizeof(float) == 4, "f");
    struct {
        int kind : 4, : 4, flag : 1;
    };
    int tail;
};
static struct v g = { .x = 1, .z = 3, .flag = 1, .tail = 9 }, h = { {{1,2,3}}, {4, 1}, 5 },
    k = { .e = {7,8,9}, .kind = -2 };
typedef struct node {
    enum {
        LEAF, BRANCH
    } type;
    union {
        int leaf;
        struct {
            struct node *left, *right;
        };
    };
} node;
static int sum(node *n){
    return n->type == LEAF ? n->leaf : sum(n->left) + sum(n->right);
}
struct o {
    struct {
        struct {
            int deep;
        };
        int mid;
    };
    int out;
} o = { .mid = 2, .deep = 1, 3 };
int main(void){
    printf("%g %g %g %d %d\n", g.e[0], g.y, g.e[2], g.flag, g.tail);
    printf("%g %d %d %d %g %d\n", h.e[1], h.kind, h.flag, h.tail, k.z, k.kind);
    node a = {LEAF, .leaf = 3}, b = {.type = LEAF, {4}}, c = {BRANCH, .left = &a, .right = &b};
    printf("%d\n", sum(&c));
    printf("%d %d %d\n", o.deep, o.mid, o.out);
    printf("%d\n", (int)((char*)&o.mid - (char*)&o));
    struct o *p = &o;
    p->deep += 5;
    printf("%d\n", p->deep);
    return 0;
}

