/* A computed goto to an address that is not a label's. */
int main(int argc, char **argv)
{
    void *table[] = {&&end, 0};

    goto *table[argc]; // error: goto to no label
end:
    return 0;
}
