/* A member of what is not there: the value that some functions give for failure, less a little. */
int main(void)
{
    struct { int a, b; } *p = (void *) -8;

    return p->b; // error: pointer outside memory
}
