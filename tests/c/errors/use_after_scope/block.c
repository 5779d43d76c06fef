/* A pointer outlives the block that declares the variable it points to. */
int main(void)
{
    int *p;

    {
        int inner = 3;
        p = &inner;
    }
    return *p; // error: use after scope
}
